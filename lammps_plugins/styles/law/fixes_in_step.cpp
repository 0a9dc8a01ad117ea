// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/fixes_in_step.h"

#include <algorithm>

#include "atom.h"
#include "law/disc_law.h"

namespace mikromakro::styles {

AddedLoads::AddedLoads(DiscLaw* law, LAMMPS_NS::Atom& atom) : atom_(atom) {
  if (!law) return;
  spins_ = law->rows_have_spins();
  if (!law->step_is_open()) return;
  law->complete_step();
  open_ = &law->shared_.packed;
}

void AddedLoads::add(int i, const physics::PlaneVector& force) {
  if (open_) {
    open_->loads[i].add_force(force.x, force.y);
  } else {
    atom_.f[i][0] += force.x;
    atom_.f[i][1] += force.y;
  }
}

void AddedLoads::add(int i, const physics::PlaneVector& force, double torque) {
  add(i, force);
  if (!spins_) return;
  if (open_) {
    open_->loads[i].add_torque(torque, open_->discs[i].radius());
  } else {
    atom_.torque[i][2] += torque;
  }
}

CarriedDiscs::CarriedDiscs(DiscLaw& law) : packed_(law.shared_.packed) {
  law.complete_step();
}

void CarriedDiscs::moved_by(double at_most) {
  packed_.furthest = std::max(packed_.furthest, at_most);
}

}  // namespace mikromakro::styles
