// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/fix_wall_disc.h"

#include <mpi.h>

#include <algorithm>
#include <type_traits>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "engine/restart_state.h"
#include "error.h"
#include "modify.h"
#include "update.h"

namespace mikromakro::styles {

using physics::PlaneVector;
using physics::SmoothWall;
using physics::WallShape;

namespace {

constexpr int first_id = -11;

// Restart data in addition to the springs.
struct SavedState {
  SmoothWall wall;  // as given in the script
  PlaneVector start;
  double start_time, power, work;
  double elapsed, step_of_clock, dt, step_of_file;
};
static_assert(std::is_trivially_copyable_v<SavedState>);

}  // namespace

FixWallDisc::FixWallDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) : FixWithWalls(engine, narg, arg) {
  scalar_flag = vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extscalar = extvector = 0;
  Arguments arguments(*lmp, style, narg, arg, 3);
  settings_ = parse_wall_disc(*lmp, arguments);
  start_ = settings_.wall.point;
  clock_ = physics::StepClock(0.0, update->ntimestep, update->dt);
  walls_.add(first_id, settings_.wall.shape == WallShape::flat ? "plane" : "circle", settings_.type);
  walls_.act_on(groupbit, 0);
  store_springs_with_atoms();
}

// Called after the restart state, if any, has been read.
void FixWallDisc::once_defined() {
  walls_.check_cuts({wall_at(update->ntimestep)});
}

void FixWallDisc::init() {
  notice_new_count();
  saved_walls_.warn_of_unclaimed(*lmp);
  follow_time_step(update->ntimestep);
  int before = 0;
  for (const Fix* fix : fixes(*modify)) {
    if (fix == this) break;
    before += dynamic_cast<const FixWallDisc*>(fix) ? 1 : 0;
  }
  walls_.show_as(0, first_id - before);
  largest_radius_ = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (atom->mask[i] & groupbit) largest_radius_ = std::max(largest_radius_, atom->radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest_radius_, 1, MPI_DOUBLE, MPI_MAX, world);
  const SmoothWall wall = wall_at(update->ntimestep);
  check_periodic_images(wall);
  warn_outside_box(wall);
  walls_.init({wall});
  step_of_loads_ = -1;
}

// Discs interact with the wall itself only, not with periodic images of it.
void FixWallDisc::check_periodic_images(const SmoothWall& wall) const {
  const double extent = wall.radius + largest_radius_;
  const bool flat = wall.shape == WallShape::flat;
  const auto check = [&](bool periodic, double normal, double point, int axis) {
    if (!periodic) return;
    const std::string name = axis == 0 ? "x" : "y";
    if (flat && normal != 0)
      stop(*lmp, style,
           "plane: expected a normal without a component along " + name +
               ", in which the box is periodic, got " + text_of(-normal));
    if (!flat && (point - extent < domain->boxlo[axis] || point + extent > domain->boxhi[axis]))
      stop(*lmp, style,
           "circle: expected it, and discs at it, inside the box along " + name +
               ", in which the box is periodic: from " + text_of(domain->boxlo[axis]) + " to " +
               text_of(domain->boxhi[axis]) + ", got " + text_of(point - extent) + " to " +
               text_of(point + extent));
  };
  check(domain->xperiodic != 0, wall.outward.x, wall.point.x, 0);
  check(domain->yperiodic != 0, wall.outward.y, wall.point.y, 1);
}

/// Discs are lost at a fixed side of the box before they reach a wall beyond it.
void FixWallDisc::warn_outside_box(const SmoothWall& wall) const {
  const bool flat = wall.shape == WallShape::flat;
  const auto open = [&](int axis) {
    return domain->boundary[axis][0] == 1 && domain->boundary[axis][1] == 1;
  };
  const double* low = domain->boxlo;
  const double* high = domain->boxhi;
  bool outside = false;
  if (flat && open(0) && open(1)) {
    // True if even the corner of the box nearest to the wall does not reach it.
    const PlaneVector nearest{wall.outward.x > 0 ? high[0] : low[0], wall.outward.y > 0 ? high[1] : low[1]};
    outside = (nearest.x - wall.point.x) * wall.outward.x + (nearest.y - wall.point.y) * wall.outward.y < 0;
  }
  if (wall.shape == WallShape::circle_around) {
    const double x = wall.point.x, y = wall.point.y, r = wall.radius;
    outside =
        (open(0) && (x - r < low[0] || x + r > high[0])) || (open(1) && (y - r < low[1] || y + r > high[1]));
  }
  if (outside && comm->me == 0)
    error->warning(FLERR, ("fix " + std::string(id) + " (" + style +
                           "): the wall is outside of the box, where discs are lost before they reach it; "
                           "expected a larger box, or shrink-wrapped boundaries")
                              .c_str());
}

SmoothWall FixWallDisc::wall_at(LAMMPS_NS::bigint step) const {
  SmoothWall wall = settings_.wall;
  const double time = clock_.time_at(step) - start_time_;
  wall.point = {start_.x + wall.velocity.x * time, start_.y + wall.velocity.y * time};
  return wall;
}

// The command `timestep` does not notify fixes.
void FixWallDisc::follow_time_step(LAMMPS_NS::bigint step) {
  if (update->dt != clock_.dt()) clock_.change_step_length(step, update->dt);
}

void FixWallDisc::reset_dt() {
  follow_time_step(update->ntimestep);
}

void FixWallDisc::renumber_steps(LAMMPS_NS::bigint shift) {
  clock_.shift_steps(shift);
  step_of_loads_ = -1;
}

double FixWallDisc::apply() {
  const SmoothWall wall = wall_at(update->ntimestep);
  if (wall.velocity != PlaneVector{}) check_periodic_images(wall);
  walls_.apply({wall});
  step_of_loads_ = -1;
  const physics::WallLoad& load = walls_.loads()[0];
  return -(load.force.x * wall.velocity.x + load.force.y * wall.velocity.y +
           load.torque * wall.rotation_rate);
}

// A continued run uses the power of the last step, whose velocities were predicted.
void FixWallDisc::setup(int /*vflag*/) {
  const double power = apply();
  if (!continues_) power_ = power;
}

// Work by the trapezoidal rule from the power at both ends of the step.
void FixWallDisc::post_force(int /*vflag*/) {
  follow_time_step(update->ntimestep - 1);
  const double before = power_;
  power_ = apply();
  work_ += (before + power_) / 2 * update->dt;
  continues_ = true;
}

double FixWallDisc::sum_of_all_ranks(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, world);
  return value;
}

double FixWallDisc::compute_scalar() {
  return sum_of_all_ranks(work_);
}

const std::array<double, 4>& FixWallDisc::loads() {
  if (step_of_loads_ == update->ntimestep) return loads_;
  const physics::WallLoad& load = walls_.loads()[0];
  loads_ = {load.force.x, load.force.y, load.torque, load.pressing};
  if (settings_.wall.shape == WallShape::flat) {
    const PlaneVector point = wall_at(update->ntimestep).point;
    loads_[2] += point.x * load.force.y - point.y * load.force.x;
  }
  MPI_Allreduce(MPI_IN_PLACE, loads_.data(), 4, MPI_DOUBLE, MPI_SUM, world);
  step_of_loads_ = update->ntimestep;
  return loads_;
}

double FixWallDisc::compute_vector(int i) {
  if (i == 3) return compute_scalar();
  return loads()[i < 3 ? i : 3];
}

// The sums over all ranks are assigned to the first one, here and in the continued run, so that both add the
// same numbers.
void FixWallDisc::write_restart(FILE* file) {
  const double power = sum_of_all_ranks(power_), work = sum_of_all_ranks(work_);
  power_ = comm->me == 0 ? power : 0.0;
  work_ = comm->me == 0 ? work : 0.0;
  if (comm->me != 0) return;
  const SavedState state{settings_.wall,
                         start_,
                         start_time_,
                         power_,
                         work_,
                         clock_.elapsed(),
                         static_cast<double>(clock_.step()),
                         clock_.dt(),
                         static_cast<double>(update->ntimestep)};
  write_state(file, state);
}

void FixWallDisc::restart(char* buffer) {
  const auto state = read_state<SavedState>(*lmp, *this, buffer);
  if (!same_place(state.wall, settings_.wall)) {
    print_line(
        *lmp,
        "WARNING: fix " + std::string(id) + " (" + style +
            "): not where it was in the restart file: it starts afresh at the position given in the script");
    return;
  }
  clock_ = physics::StepClock(state.elapsed, static_cast<LAMMPS_NS::bigint>(state.step_of_clock), state.dt);
  // Steps may have been renumbered since read_restart.
  clock_.shift_steps(update->ntimestep - static_cast<LAMMPS_NS::bigint>(state.step_of_file));
  start_ = state.start;
  start_time_ = state.start_time;
  if (comm->me == 0) power_ = state.power, work_ = state.work;
  continues_ = true;
  if (state.wall == settings_.wall) return;
  // A new motion starts from the wall's present position.
  const SmoothWall given = settings_.wall;
  settings_.wall = state.wall;
  start_ = wall_at(update->ntimestep).point;
  start_time_ = clock_.time_at(update->ntimestep);
  settings_.wall = given;
}

}  // namespace mikromakro::styles
