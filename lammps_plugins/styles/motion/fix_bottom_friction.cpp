// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/fix_bottom_friction.h"

#include <mpi.h>

#include <array>

#include "atom.h"
#include "comm.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/restart_state.h"
#include "law/disc_law.h"
#include "law/fixes_in_step.h"
#include "physics/walls/bottom_friction.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

FixBottomFriction::FixBottomFriction(LAMMPS* engine, int narg, char** arg) : FixOfEngine(engine, narg, arg) {
  Arguments arguments(*lmp, "fix bottom/friction", narg, arg, 3);
  mu_b_ = arguments.positive("coefficient of friction");
  g_ = arguments.positive("acceleration of gravity");
  while (arguments.more()) {
    if (!arguments.take_once("velocity")) arguments.unexpected("the keyword velocity");
    given_v_0_ = arguments.positive("velocity");
  }
  if (!atom->rmass_flag) arguments.fail(std::string("needs 'atom_style ") + disc_atom_style + "'");
  scalar_flag = vector_flag = extscalar = extvector = global_freq = size_vector = 1;
  restart_global = 1;
}

int FixBottomFriction::setmask() {
  return FixConst::POST_FORCE;
}

void FixBottomFriction::init() {
  reset_dt();
  law_ = active_disc_law(*lmp);
}

void FixBottomFriction::reset_dt() {
  const double lost = physics::velocity_lost_in_a_step(mu_b_, g_, update->dt);
  v_0_ = given_v_0_ > 0 ? given_v_0_ : physics::default_regularisation * lost;
  const double least = physics::least_regularisation * lost;
  if (v_0_ < least) {
    stop(*lmp, "fix bottom/friction",
         "velocity: expected at least 2 mu_b g dt = " + text_of(least) + " m/s, got " + text_of(v_0_));
  }
}

/// Uses the velocities that contacts use.
double FixBottomFriction::apply() {
  AddedLoads loads(law_, *atom);
  double power = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const auto* row = law_ ? law_->evaluated_row(i) : nullptr;
    const auto v = row ? row->velocity() : physics::PlaneVector{atom->v[i][0], atom->v[i][1]};
    const auto force = physics::bottom_friction(mu_b_ * g_ * atom->rmass[i], v, v_0_);
    loads.add(i, force);
    power -= force.x * v.x + force.y * v.y;
  }
  return power;
}

/// A continued run uses the power of the last step, whose velocities were predicted.
void FixBottomFriction::setup(int /*vflag*/) {
  const double power = apply();
  if (!continues_) power_ = power;
}

/// Energy by the trapezoidal rule from the power at both ends of the step.
void FixBottomFriction::post_force(int /*vflag*/) {
  const double before = power_;
  power_ = apply();
  energy_ += (before + power_) / 2 * update->dt;
  continues_ = true;
}

double FixBottomFriction::sum_of_all_ranks(double value) const {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, world);
  return value;
}

double FixBottomFriction::compute_scalar() {
  return sum_of_all_ranks(energy_);
}

double FixBottomFriction::compute_vector(int /*n*/) {
  return sum_of_all_ranks(power_);
}

// The sums over all ranks are assigned to the first one, here and in the continued run, so that both add the
// same numbers.
void FixBottomFriction::write_restart(FILE* file) {
  std::array<double, 2> state{sum_of_all_ranks(power_), sum_of_all_ranks(energy_)};
  if (comm->me != 0) state.fill(0.0);
  power_ = state[0];
  energy_ = state[1];
  if (comm->me != 0) return;
  write_state(file, state);
}

void FixBottomFriction::restart(char* buffer) {
  auto state = read_state<std::array<double, 2>>(*lmp, *this, buffer);
  if (comm->me != 0) state.fill(0.0);
  power_ = state[0];
  energy_ = state[1];
  continues_ = true;
}

}  // namespace mikromakro::styles
