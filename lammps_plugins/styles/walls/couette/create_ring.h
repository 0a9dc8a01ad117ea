// SPDX-License-Identifier: GPL-2.0-or-later
// create_ring X Y R {pitch P | number N} type T radius A density RHO [phase PHI]
//
// Places equally spaced wall discs with their centres on the circle of radius R (m) about (X, Y) (m): N
// discs, or N = round(2 pi R/P), the first at angle PHI (rad, counter-clockwise from x; default 0). A is the
// radius of a wall disc (m), RHO the areal density rho h (kg/m^2). Keywords may come in any order.
#pragma once

#include "dialect.h"

namespace mikromakro::styles {

class CreateRing : public CommandOfEngine {
 public:
  explicit CreateRing(LAMMPS_NS::LAMMPS* lmp) : CommandOfEngine(lmp) {}
  void command(int narg, char** arg) override;
};

}  // namespace mikromakro::styles
