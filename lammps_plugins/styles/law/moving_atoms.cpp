// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/moving_atoms.h"

#include <mpi.h>

#include <array>
#include <string_view>
#include <vector>

#include "atom.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

bool replaces_forces_of_all(Fix& fix, const Atom& atom, MPI_Comm world) {
  std::vector<std::array<double, 3>> forces(atom.nlocal);
  const auto probe = [](int i) { return 1 + 1.0 / (i + 2); };  // no two alike, so that no mean is one of them
  for (int i = 0; i < atom.nlocal; ++i) {
    double* f = atom.f[i];
    forces[i] = {f[0], f[1], f[2]};
    f[0] = f[1] = f[2] = probe(i);
  }
  fix.post_force(0);
  int all = 1;
  for (int i = 0; i < atom.nlocal; ++i) {
    double* f = atom.f[i];
    if ((atom.mask[i] & fix.groupbit) && (f[0] == probe(i) || f[1] == probe(i))) all = 0;
    f[0] = forces[i][0];
    f[1] = forces[i][1];
    f[2] = forces[i][2];
  }
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, world);
  return all != 0;
}

}  // namespace

int groups_with_set_forces(LAMMPS& engine) {
  int groups = 0;
  for (Fix* fix : fixes(*engine.modify)) {
    const std::string_view style = fix->style;
    if ((style == "setforce" || style == "aveforce") &&
        replaces_forces_of_all(*fix, *engine.atom, engine.world))
      groups |= fix->groupbit;
  }
  return groups;
}

MovingAtoms::MovingAtoms(const Modify& modify, int groups_with_set_forces) : held_(groups_with_set_forces) {
  for (const Fix* fix : fixes(modify)) {
    const std::string_view style = fix->style;
    if (style == "freeze") frozen_ |= fix->groupbit;
    if (style.starts_with("nve/noforce")) continue;
    for (const char* integrates : {"nve", "nvt", "npt", "nph"})
      if (style.starts_with(integrates)) integrated_ |= fix->groupbit;
  }
}

bool MovingAtoms::include(const Atom& atom, int i) const {
  const int mask = atom.mask[i];
  if (!(mask & integrated_) || (mask & frozen_)) return false;
  return !(mask & held_) || atom.v[i][0] != 0 || atom.v[i][1] != 0;
}

}  // namespace mikromakro::styles
