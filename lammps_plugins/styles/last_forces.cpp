#include "last_forces.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "lammps.h"

namespace mikromakro::styles {

namespace {

/// Whether two coordinates are the same place; the engine wraps discs into a periodic box between runs.
bool same_place(double a, double b, bool periodic, double period) {
  if (a == b) return true;
  constexpr double rounding = 1e-12;
  return periodic && std::abs(std::remainder(a - b, period)) <= rounding * period;
}

}  // namespace

void LastForces::keep(int group_bit) {
  const auto& atom = *engine_.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!(atom.mask[i] & group_bit)) continue;
    kept_[i] = {1,
                {atom.x[i][0], atom.x[i][1]},
                {atom.v[i][0], atom.v[i][1], atom.omega[i][2]},
                {atom.f[i][0], atom.f[i][1], atom.torque[i][2]}};
  }
}

bool LastForces::unchanged(int i) const {
  const auto& atom = *engine_.atom;
  const auto& domain = *engine_.domain;
  const Kept& kept = kept_[i];
  if (kept.valid == 0 || kept.motion[0] != atom.v[i][0] || kept.motion[1] != atom.v[i][1] ||
      kept.motion[2] != atom.omega[i][2])
    return false;
  return same_place(kept.x[0], atom.x[i][0], domain.xperiodic != 0, domain.prd[0]) &&
         same_place(kept.x[1], atom.x[i][1], domain.yperiodic != 0, domain.prd[1]);
}

void LastForces::restore(int group_bit) const {
  const auto& atom = *engine_.atom;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!(atom.mask[i] & group_bit) || !unchanged(i)) continue;
    atom.f[i][0] = kept_[i].load[0];
    atom.f[i][1] = kept_[i].load[1];
    atom.torque[i][2] = kept_[i].load[2];
  }
}

int LastForces::pack(int i, double* buffer) const {
  const Kept& k = kept_[i];
  const double numbers[values] = {k.valid,     k.x[0],    k.x[1],    k.motion[0], k.motion[1],
                                  k.motion[2], k.load[0], k.load[1], k.load[2]};
  std::copy_n(numbers, values, buffer);
  return values;
}

int LastForces::unpack(int i, const double* buffer) {
  const double* b = buffer;
  kept_[i] = {b[0], {b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
  return values;
}

}  // namespace mikromakro::styles
