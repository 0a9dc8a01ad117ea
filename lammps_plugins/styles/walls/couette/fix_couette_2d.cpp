// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/couette/fix_couette_2d.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"
#include "law/fixes_in_step.h"
#include "memory.h"
#include "update.h"

namespace mikromakro::styles {

FixCouette2d::FixCouette2d(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
    : FixWithClock(lmp, narg, arg), walls_(*lmp, style), saved_walls_(*lmp, style) {
  restart_global = 1;
  restart_peratom = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 9;
  global_freq = 1;
  extscalar = extvector = 0;
  has_values_of_atoms(2 + WallSprings::largest_size);

  if (domain->dimension != 2) stop(*lmp, style, "expected 'dimension 2', got dimension 3");
  if (!atom->radius_flag || !atom->omega_flag || !atom->torque_flag)
    stop(*lmp, style,
         "expected an atom style with radius, omega and torque, such as " + std::string(disc_atom_style));
  Arguments arguments(*lmp, style, narg, arg, 3);
  settings_ = parse_couette(*lmp, arguments);
  clock_ = physics::StepClock(0.0, update->ntimestep, update->dt);
  add_smooth_rings();
  // Avoids the engine's warning of atoms with two integrators: with smooth rings the group includes discs
  // that other fixes integrate.
  time_integrate = walls_.any() ? 0 : 1;

  grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixCouette2d::~FixCouette2d() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(references_);
}

int FixCouette2d::calls_wanted() const {
  return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::PRE_EXCHANGE |
         (walls_.any() ? LAMMPS_NS::FixConst::POST_FORCE : 0);
}

// Called after the restart state, if any, has been read.
void FixCouette2d::once_defined() {
  check_groups();
  check_integrators();
  check_radii();
  adopt_new_wall_discs();
  walls_.check_cuts(smooth_rings_at(update->ntimestep));
}

void FixCouette2d::init() {
  notice_new_count();
  saved_walls_.warn_of_unclaimed(*lmp);
  follow_time_step(update->ntimestep);
  check_groups();
  check_radii();
  adopt_new_wall_discs();
  if (walls_.any()) walls_.init(smooth_rings_at(update->ntimestep));
  law_ = active_disc_law(*lmp);
}

// Sets velocities at the start of a run, before ghosts receive theirs. Positions are untouched: they are
// correct, or check_radii() has stopped the run. Forces will be re-evaluated, perhaps under another law, so
// the loads from the end of the last run are discarded: averages taken in the set-up, possibly before that of
// this fix, must not use them.
void FixCouette2d::setup_pre_exchange() {
  place_wall_discs(update->ntimestep, true);
  step_of_loads_ = -1;
  members_known_ = false;
}

// Wall discs are about to change indices and ranks.
void FixCouette2d::pre_exchange() {
  members_known_ = false;
}

void FixCouette2d::setup(int vflag) {
  if (walls_.any()) post_force(vflag);
  step_of_loads_ = -1;
}

void FixCouette2d::post_force(int) {
  walls_.apply(smooth_rings_at(update->ntimestep));
}

void FixCouette2d::initial_integrate(int) {
  follow_time_step(update->ntimestep - 1);
  if (law_ && law_->step_is_open()) {
    carry_rows(update->ntimestep);
  } else {
    place_wall_discs(update->ntimestep, false);
  }
}

void FixCouette2d::reset_dt() {
  follow_time_step(update->ntimestep);
}

void FixCouette2d::renumber_steps(LAMMPS_NS::bigint shift) {
  clock_.shift_steps(shift);
  step_of_loads_ = -1;
}

FixCouette2d::Rings FixCouette2d::rings_at(LAMMPS_NS::bigint step) const {
  const double time = clock_.time_at(step);
  return {settings_.rings[0].motion.at(time), settings_.rings[1].motion.at(time)};
}

int FixCouette2d::ring_of(int i) const {
  if (atom->mask[i] & settings_.rings[0].group_bit) return 0;
  if (atom->mask[i] & settings_.rings[1].group_bit) return 1;
  return -1;
}

physics::PlaneVector FixCouette2d::from_centre(int i) const {
  return {atom->x[i][0] - settings_.centre.x, atom->x[i][1] - settings_.centre.y};
}

// The command `timestep` does not notify fixes.
void FixCouette2d::follow_time_step(LAMMPS_NS::bigint step) {
  if (update->dt != clock_.dt()) clock_.change_step_length(step, update->dt);
}

void FixCouette2d::place_wall_discs(LAMMPS_NS::bigint step, bool velocities_only) {
  const Rings rings = rings_at(step);
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side < 0) continue;
    const physics::WallDiscState disc =
        physics::wall_disc_state(rings[side], {references_[i][0], references_[i][1]});
    if (!velocities_only) {
      atom->x[i][0] = settings_.centre.x + disc.position.x;
      atom->x[i][1] = settings_.centre.y + disc.position.y;
    }
    atom->v[i][0] = disc.velocity.x;
    atom->v[i][1] = disc.velocity.y;
    atom->omega[i][2] = rings[side].rotation_rate;
  }
}

void FixCouette2d::find_members() {
  for (auto& ring : members_) ring.clear();
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side >= 0) members_[side].push_back(i);
  }
  members_known_ = true;
}

// As place_wall_discs(), if velocities are needed in the rows only; a ring at rest is skipped.
void FixCouette2d::carry_rows(LAMMPS_NS::bigint step) {
  if (!members_known_) find_members();
  CarriedDiscs discs(*law_);
  const Rings rings = rings_at(step);
  for (int side = 0; side < 2; ++side) {
    const auto& ring = rings[side];
    if (ring.rotation_rate == 0 && settings_.rings[side].motion.course.is_over(clock_.time_at(step - 1)))
      continue;
    for (const int i : members_[side]) {
      const physics::WallDiscState disc =
          physics::wall_disc_state(ring, {references_[i][0], references_[i][1]});
      discs.carry(i, {settings_.centre.x + disc.position.x, settings_.centre.y + disc.position.y},
                  disc.velocity, ring.rotation_rate);
    }
    const double before = settings_.rings[side].motion.course.radius(clock_.time_at(step - 1));
    const double turned = std::abs(ring.rotation_rate) * clock_.dt() * std::max(before, ring.radius);
    discs.moved_by(std::abs(ring.radius - before) + turned);
  }
}

const FixCouette2d::Loads& FixCouette2d::loads() {
  if (step_of_loads_ == update->ntimestep) return loads_;
  loads_ = {};
  for (int i = 0; i < atom->nlocal; ++i) {
    const int side = ring_of(i);
    if (side >= 0) loads_[side].add(from_centre(i), {atom->f[i][0], atom->f[i][1]}, atom->torque[i][2]);
  }
  add_loads_of_smooth_rings();
  static_assert(sizeof(Loads) == 4 * sizeof(double));
  MPI_Allreduce(MPI_IN_PLACE, loads_.data(), 4, MPI_DOUBLE, MPI_SUM, world);
  step_of_loads_ = update->ntimestep;
  return loads_;
}

double FixCouette2d::compute_scalar() {
  return compute_vector(0);
}

double FixCouette2d::compute_vector(int i) {
  const Rings rings = rings_at(update->ntimestep);
  const auto pressure = [&](physics::RingSide side, int k) {
    return physics::ring_pressure(side, loads()[k], rings[k].radius, settings_.height);
  };
  switch (i) {
    case 0:
      return loads()[0].torque;
    case 1:
      return loads()[1].torque;
    case 2:
      return pressure(physics::RingSide::inner, 0);
    case 3:
      return pressure(physics::RingSide::outer, 1);
    case 4:
      return rings[0].angle;
    case 5:
      return rings[1].angle;
    case 6:
      return rings[1].radius;
    case 7:
      return rings[1].radial_velocity;
    case 8:
      return physics::ring_power(loads()[0], rings[0].rotation_rate);
    default:
      return 0.0;
  }
}

double FixCouette2d::memory_usage() {
  return 2.0 * atom->nmax * sizeof(double) + walls_.springs().memory_usage();
}

}  // namespace mikromakro::styles
