// SPDX-License-Identifier: GPL-2.0-or-later
// Inserts new discs into the running engine: every rank has the same list and takes what lies in its part
// of the box, so that ids and positions do not depend on the number of ranks.
#pragma once

#include <string>
#include <vector>

#include "physics/disc_grid.h"
#include "physics/disc_region.h"
#include "physics/plane_vector.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

struct NewDisc {
  physics::PlacedDisc place;
  int type = 1;
  physics::PlaneVector velocity;  // m/s
};

// Ends the run on all ranks unless discs can be inserted now: a box exists, dimension 2, an atom style that
// stores radius, mass and density.
void check_ready_for_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style);

// Ends the run on all ranks if `what`, whose outermost points are `bounds`, does not fit into the box. Sides
// that the engine moves with the discs (shrink-wrapped) are not checked.
void check_inside_box(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what,
                      const physics::Rectangle& bounds);

// The ids go on after the largest existing one, in the order of the list. `areal_density` is rho h in kg/m^2,
// so that the mass is pi a^2 areal_density, as LIGGGHTS itself has it in two dimensions (LAMMPS: of `set
// density/disc`).
void insert_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::vector<NewDisc>& discs,
                  double areal_density);

// All discs that exist, of all ranks, and their images that reach into a periodic box; their order depends on
// the number of ranks.
std::vector<physics::PlacedDisc> existing_discs(LAMMPS_NS::LAMMPS& engine);

// One line on screen and in the log file, from the first rank.
void say(LAMMPS_NS::LAMMPS& engine, const std::string& line);

}  // namespace mikromakro::styles
