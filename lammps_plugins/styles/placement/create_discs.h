// SPDX-License-Identifier: GPL-2.0-or-later
// create_discs ring X Y R1 R2 seed S density RHO FILLING... [velocity VMAX] [gap G]
// create_discs box XLO XHI YLO YHI seed S density RHO FILLING... [velocity VMAX] [gap G]
//   FILLING = discs N TYPE RADIUS | uniform N TYPE RMIN RMAX, one or more
//
// Fills a ring (R1 = 0: a circle) or a rectangle with randomly placed discs that overlap neither each other
// nor existing discs (periodic images are ignored), and whose rims are at least G (m, default 0) inside the
// border. `discs`: N discs of one radius; `uniform`: radii uniform in [RMIN, RMAX]. RHO is the areal density
// rho h (kg/m^2). VMAX (m/s, default 0): initial velocities uniform in a disc of that radius. Ids follow the
// order of the command. The result is bitwise independent of the number of ranks. Keywords may come in any
// order.
#pragma once

#include "dialect.h"

namespace mikromakro::styles {

class CreateDiscs : public CommandOfEngine {
 public:
  explicit CreateDiscs(LAMMPS_NS::LAMMPS* lmp) : CommandOfEngine(lmp) {}
  void command(int narg, char** arg) override;
};

}  // namespace mikromakro::styles
