// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/packed_discs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atom.h"

namespace mikromakro::styles {

using LAMMPS_NS::Atom;
using physics::DiscLoad;
using physics::DiscRow;

namespace {

using Vector3 = double[3];

const Vector3* vectors(double** of_atoms) {
  return reinterpret_cast<const Vector3*>(of_atoms[0]);
}

/// Reading the engine's arrays in the pair loop would cost a cache line per array and neighbour.
template <bool spins>
DiscChange pack_rows(DiscRow* discs, const Atom& atom, int first) {
  const int count = atom.nlocal + atom.nghost;
  const Vector3 *x = vectors(atom.x), *v = vectors(atom.v), *omega = vectors(atom.omega);
  const double* radius = atom.radius;
  double furthest = 0, growth = 0;
  for (int i = first; i < count; ++i) {
    const double d_x = x[i][0] - discs[i].x(), d_y = x[i][1] - discs[i].y();
    furthest = std::max(furthest, d_x * d_x + d_y * d_y);
    growth = std::max(growth, radius[i] - discs[i].radius());
    discs[i] = DiscRow::of(x[i][0], x[i][1], radius[i]);
    discs[i].set_motion(v[i][0], v[i][1], spins ? omega[i][2] : 0.0);
  }
  return {std::sqrt(furthest), growth};
}

}  // namespace

DiscChange PackedDiscs::pack(const Atom& atom, int first, bool spins) {
  const int count = atom.nlocal + atom.nghost;
  discs.resize(count);
  loads.resize(count);
  DiscRow* rows = discs.data();
  DiscChange change = spins ? pack_rows<true>(rows, atom, first) : pack_rows<false>(rows, atom, first);
  const double by_movers = std::exchange(furthest, 0.0);
  if (first > 0) change.moved = std::max(change.moved, by_movers);
  return change;
}

void PackedDiscs::unpack(Atom& atom, int i, bool spins) const {
  const DiscRow& disc = discs[i];
  atom.x[i][0] = disc.x();
  atom.x[i][1] = disc.y();
  atom.v[i][0] = disc.motion[0];
  atom.v[i][1] = disc.motion[1];
  if (spins) atom.omega[i][2] = disc.motion[2];
}

void PackedDiscs::unpack_owned(Atom& atom, bool spins) const {
  for (int i = 0; i < atom.nlocal; ++i) unpack(atom, i, spins);
}

void PackedDiscs::unload(Atom& atom, bool spins, bool overwrite) {
  auto* f = reinterpret_cast<Vector3*>(atom.f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom.torque[0]);
  const int nlocal = atom.nlocal;
  for (int i = 0; i < nlocal && overwrite; ++i) f[i][0] = f[i][1] = torque[i][2] = 0;
  for (int i = 0; i < nlocal; ++i) {
    f[i][0] += loads[i].f_x();
    f[i][1] += loads[i].f_y();
  }
  for (int i = 0; i < nlocal && spins; ++i) torque[i][2] += loads[i].torque(discs[i].radius());
  std::fill(loads.begin(), loads.end(), DiscLoad{});
}

}  // namespace mikromakro::styles
