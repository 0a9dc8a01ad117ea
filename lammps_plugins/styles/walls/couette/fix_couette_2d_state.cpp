// SPDX-License-Identifier: GPL-2.0-or-later
// fix couette/2d: checks, per-atom data and restart.
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "engine/engine_lists.h"
#include "engine/restart_state.h"
#include "group.h"
#include "memory.h"
#include "modify.h"
#include "placement/disc_insertion.h"
#include "update.h"
#include "walls/couette/fix_couette_2d.h"

namespace mikromakro::styles {
namespace {

// A disc further off its ring than this, relative to the radius, was not placed by create_ring: rounding is
// 1e-16.
constexpr double radius_tolerance = 1e-9;
const std::array<std::string, 2> side_names = {"inner", "outer"};

// Restart data in addition to the references: the clock and the state of the rings.
struct SavedState {
  double elapsed;
  double step_of_clock;
  double dt;
  double step_of_file;
  std::array<double, 2> angle_offset;
  std::array<double, 2> rotation_rate;
  std::array<double, 2> radius;
};

}  // namespace

void FixCouette2d::check_groups() {
  std::array<long, 4> counts{};  // inner, outer, in both, outside the fix's own group
  double largest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side < 0) continue;
    ++counts[side];
    if (side == 0 && (atom->mask[i] & settings_.rings[1].group_bit)) ++counts[2];
    if (!(atom->mask[i] & groupbit)) ++counts[3];
    largest = std::max(largest, atom->radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, counts.data(), 4, MPI_LONG, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (counts[2] > 0)
    stop(*lmp, style, "expected two groups without common discs, got " + std::to_string(counts[2]));
  for (int side = 0; side < 2; ++side) {
    if (counts[side] == 0 && !settings_.rings[side].smooth())
      stop(*lmp, style,
           side_names[side] + " rough: expected a group with wall discs, got the empty group '" +
               settings_.rings[side].group + "'");
  }
  if (counts[3] > 0)
    stop(*lmp, style,
         "expected the fix's group to hold both rings, got " + std::to_string(counts[3]) +
             " wall discs outside of group '" + group->names[igroup] + "'");
  const physics::RadiusCourse& course = settings_.rings[1].motion.course;
  const physics::Annulus outline{settings_.centre.x, settings_.centre.y, 0.0,
                                 std::max(course.start, course.end) + largest};
  check_inside_box(*lmp, style, "the outer ring", outline.bounds());
}

/// No other fix may move the wall discs.
void FixCouette2d::check_integrators() const {
  for (const Fix* fix : fixes(*modify)) {
    const Fix& other = *fix;
    const bool integrates = other.time_integrate || std::strncmp(other.style, "nve", 3) == 0;
    if (&other == this || !integrates) continue;
    int disc = std::numeric_limits<int>::max();
    for (int i = 0; i < atom->nlocal; ++i)
      if (ring_of(i) >= 0 && (atom->mask[i] & other.groupbit))
        disc = std::min(disc, static_cast<int>(atom->tag[i]));
    MPI_Allreduce(MPI_IN_PLACE, &disc, 1, MPI_INT, MPI_MIN, world);
    if (disc == std::numeric_limits<int>::max()) continue;
    stop(*lmp, style,
         "the wall disc " + std::to_string(disc) + " is moved by fix " + other.id + " (" + other.style +
             "), too; expected wall discs outside of its group");
  }
}

// Stops the run if a disc is off its ring; names the one furthest off, relative to the radius.
void FixCouette2d::check_radii() {
  const Rings rings = rings_at(update->ntimestep);
  struct {
    double error = 0.0;
    int id = 0;
  } worst;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side < 0) continue;
    const physics::PlaneVector position = from_centre(i);
    const double error = std::abs(std::hypot(position.x, position.y) / rings[side].radius - 1.0);
    if (error > worst.error) worst = {error, atom->tag[i]};
  }
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  if (worst.error <= radius_tolerance) return;

  // Only the owner of the disc has its data.
  std::array<double, 3> found{};
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->tag[i] != worst.id) continue;
    const physics::PlaneVector position = from_centre(i);
    found = {std::hypot(position.x, position.y), rings[ring_of(i)].radius, static_cast<double>(ring_of(i))};
  }
  MPI_Allreduce(MPI_IN_PLACE, found.data(), 3, MPI_DOUBLE, MPI_MAX, world);
  stop(*lmp, style,
       "expected the wall disc " + std::to_string(worst.id) + " at the radius " + text_of(found[1]) +
           " of the " + side_names[static_cast<std::size_t>(found[2])] + " ring, got " + text_of(found[0]) +
           "; place wall discs with create_ring");
}

void FixCouette2d::adopt_new_wall_discs() {
  const Rings rings = rings_at(update->ntimestep);
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side < 0 || references_[i][0] != 0.0 || references_[i][1] != 0.0) continue;
    const physics::PlaneVector reference = physics::reference_direction(rings[side], from_centre(i));
    references_[i][0] = reference.x;
    references_[i][1] = reference.y;
  }
}

void FixCouette2d::grow_arrays(int nmax) {
  memory->grow(references_, nmax, 2, "couette/2d:references");
  walls_.springs().grow(nmax);
}

void FixCouette2d::copy_arrays(int i, int j, int) {
  references_[j][0] = references_[i][0];
  references_[j][1] = references_[i][1];
  walls_.springs().copy(i, j);
}

void FixCouette2d::set_arrays(int i) {
  references_[i][0] = references_[i][1] = 0.0;
  walls_.springs().clear(i);
}

int FixCouette2d::pack_exchange(int i, double* buf) {
  buf[0] = references_[i][0];
  buf[1] = references_[i][1];
  return 2 + walls_.springs().pack(i, buf + 2);
}

int FixCouette2d::unpack_exchange(int nlocal, double* buf) {
  references_[nlocal][0] = buf[0];
  references_[nlocal][1] = buf[1];
  return 2 + walls_.springs().unpack(nlocal, buf + 2);
}

void FixCouette2d::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const auto& [inner, outer] = settings_.rings;
  const Rings rings = rings_at(update->ntimestep);
  const SavedState state{clock_.elapsed(),
                         static_cast<double>(clock_.step()),
                         clock_.dt(),
                         static_cast<double>(update->ntimestep),
                         {inner.motion.angle_offset, outer.motion.angle_offset},
                         {inner.motion.rotation_rate, outer.motion.rotation_rate},
                         {rings[0].radius, rings[1].radius}};
  write_state(fp, state);
}

void FixCouette2d::restart(char* buf) {
  const auto state = read_state<SavedState>(*lmp, *this, buf);
  clock_ = physics::StepClock(state.elapsed, static_cast<LAMMPS_NS::bigint>(state.step_of_clock), state.dt);
  // Steps may have been renumbered since read_restart.
  clock_.shift_steps(update->ntimestep - static_cast<LAMMPS_NS::bigint>(state.step_of_file));
  const double time = clock_.time_at(update->ntimestep);
  for (int side = 0; side < 2; ++side) {
    physics::RingMotion& motion = settings_.rings[side].motion;
    motion.angle_offset = state.angle_offset[side];
    // A ring with a new rotation rate starts from its present angle.
    if (motion.rotation_rate != state.rotation_rate[side])
      motion.angle_offset += (state.rotation_rate[side] - motion.rotation_rate) * time;
    const double radius = motion.course.radius(time);
    if (std::abs(radius - state.radius[side]) > radius_tolerance * radius)
      stop(*lmp, style,
           side_names[side] + " ring: expected the radius it had in the restart file, " +
               text_of(state.radius[side]) + ", got " + text_of(radius) +
               " (of the fix's radius and 'compact' at that time)");
  }
}

int FixCouette2d::pack_restart(int i, double* buf) {
  buf[0] = size_restart(i);
  buf[1] = references_[i][0];
  buf[2] = references_[i][1];
  return 3 + walls_.springs().pack(i, buf + 3);
}

void FixCouette2d::unpack_restart(int nlocal, int nth) {
  const double* extra = atom->extra[nlocal];
  int start = 0;
  for (int k = 0; k < nth; ++k) start += static_cast<int>(extra[start]);
  references_[nlocal][0] = extra[start + 1];
  references_[nlocal][1] = extra[start + 2];
  walls_.springs().unpack(nlocal, extra + start + 3);
}

int FixCouette2d::size_restart(int i) {
  return 3 + walls_.springs().packed_size(i);
}

int FixCouette2d::maxsize_restart() {
  return 3 + walls_.springs().largest_packed_size();
}

}  // namespace mikromakro::styles
