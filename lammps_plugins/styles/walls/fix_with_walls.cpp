// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/fix_with_walls.h"

#include <string>

#include "atom.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"

namespace mikromakro::styles {

FixWithWalls::FixWithWalls(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixWithClock(engine, narg, arg), walls_(*engine, style), saved_walls_(*engine, style) {
  restart_global = restart_peratom = 1;
  has_values_of_atoms(WallSprings::largest_size);
  if (domain->dimension != 2) stop(*lmp, style, "expected 'dimension 2', got dimension 3");
  if (!atom->radius_flag || !atom->omega_flag || !atom->torque_flag)
    stop(*lmp, style,
         "expected an atom style with radius, omega and torque, such as " + std::string(disc_atom_style));
}

FixWithWalls::~FixWithWalls() {
  // Callbacks are missing if the constructor of the fix ended with an exception.
  if (!springs_are_kept_) return;
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixWithWalls::store_springs_with_atoms() {
  walls_.springs().grow(atom->nmax);
  for (int i = 0; i < atom->nlocal; ++i) walls_.springs().clear(i);
  atom->add_callback(0);
  atom->add_callback(1);
  springs_are_kept_ = true;
}

int FixWithWalls::pack_restart(int i, double* buffer) {
  buffer[0] = walls_.springs().packed_size(i) + 1;
  return 1 + walls_.springs().pack(i, buffer + 1);
}

void FixWithWalls::unpack_restart(int nlocal, int nth) {
  const double* extra = atom->extra[nlocal];
  int start = 0;
  for (int k = 0; k < nth; ++k) start += static_cast<int>(extra[start]);
  walls_.springs().unpack(nlocal, extra + start + 1);
}

}  // namespace mikromakro::styles
