// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/last_forces.h"

#include <mpi.h>

#include <cmath>
#include <cstring>

#include "atom.h"
#include "domain.h"
#include "lammps.h"

namespace mikromakro::styles {

namespace {

/// True if two coordinates are the same position; the engine wraps discs into a periodic box between runs.
bool same_place(double a, double b, bool periodic, double period) {
  if (a == b) return true;
  constexpr double rounding = 1e-12;
  return periodic && std::abs(std::remainder(a - b, period)) <= rounding * period;
}

}  // namespace

void LastForces::store_velocities(const physics::DiscRow* rows, bool rows_have_spins) {
  const auto& atom = *engine_.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    const auto& motion = rows[i].motion;
    kept_[i].velocities = {motion[0], motion[1], rows_have_spins ? motion[2] : atom.omega[i][2]};
  }
}

void LastForces::store_discs() {
  const auto& atom = *engine_.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    Kept& kept = kept_[i];
    kept.discs = static_cast<double>(atom.natoms);
    kept.shape = {atom.x[i][0], atom.x[i][1], atom.radius[i], static_cast<double>(atom.type[i])};
    kept.motion = {atom.v[i][0], atom.v[i][1], atom.omega[i][2]};
    kept.load = {atom.f[i][0], atom.f[i][1], atom.torque[i][2]};
  }
}

bool LastForces::unchanged(int i) const {
  const auto& atom = *engine_.atom;
  const auto& domain = *engine_.domain;
  const Kept& kept = kept_[i];
  return kept.discs == static_cast<double>(atom.natoms) && kept.motion[0] == atom.v[i][0] &&
         kept.motion[1] == atom.v[i][1] && kept.motion[2] == atom.omega[i][2] &&
         kept.shape[2] == atom.radius[i] && kept.shape[3] == atom.type[i] &&
         same_place(kept.shape[0], atom.x[i][0], domain.xperiodic != 0, domain.prd[0]) &&
         same_place(kept.shape[1], atom.x[i][1], domain.yperiodic != 0, domain.prd[1]);
}

bool LastForces::nothing_changed() const {
  int same = 1;
  for (int i = 0; i < engine_.atom->nlocal && same; ++i) same = unchanged(i) ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &same, 1, MPI_INT, MPI_MIN, engine_.world);
  return same != 0;
}

void LastForces::restore(int group_bit, double contact_force) const {
  // A force is a sum over a few contacts, each accurate to 1e-16; where they cancel, the error scales with
  // the contact forces.
  constexpr double of_sum = 1e-8, of_contacts = 1e-13;
  const auto& atom = *engine_.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!(atom.mask[i] & group_bit)) continue;
    const auto& [f_x, f_y, torque] = kept_[i].load;
    double *f = atom.f[i], *t = atom.torque[i];
    const double rounding = of_sum * std::hypot(f_x, f_y) + of_contacts * contact_force;
    const double of_torque = of_sum * std::abs(torque) + rounding * atom.radius[i];
    if (!(std::hypot(f[0] - f_x, f[1] - f_y) <= rounding && std::abs(t[2] - torque) <= of_torque)) continue;
    f[0] = f_x;
    f[1] = f_y;
    t[2] = torque;
  }
}

int LastForces::pack(int i, double* buffer) const {
  std::memcpy(buffer, &kept_[i], sizeof(Kept));
  return values;
}

int LastForces::unpack(int i, const double* buffer) {
  std::memcpy(static_cast<void*>(&kept_[i]), buffer, sizeof(Kept));
  return values;
}

}  // namespace mikromakro::styles
