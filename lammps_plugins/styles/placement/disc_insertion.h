// SPDX-License-Identifier: GPL-2.0-or-later
// Inserts new discs into the engine. Every rank has the same list and keeps the discs in its subdomain, so
// ids and positions do not depend on the number of ranks.
#pragma once

#include <string>
#include <vector>

#include "physics/math/plane_vector.h"
#include "physics/placement/disc_grid.h"
#include "physics/placement/disc_region.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

struct NewDisc {
  physics::PlacedDisc place;
  int type = 1;
  physics::PlaneVector velocity;  // m/s
};

// Stops the run on all ranks unless discs can be inserted: needs a box, dimension 2 and an atom style that
// stores radius, mass and density.
void check_ready_for_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style);

// Stops the run on all ranks if `what`, with bounding box `bounds`, does not fit into the simulation box.
// Shrink-wrapped sides are not checked.
void check_inside_box(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what,
                      const physics::Rectangle& bounds);

// Ids continue from the largest existing one, in the order of the list. `areal_density` is rho h in kg/m^2;
// the mass is pi a^2 areal_density, as in two-dimensional LIGGGHTS (LAMMPS: `set density/disc`).
void insert_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::vector<NewDisc>& discs,
                  double areal_density);

// All existing discs of all ranks, and periodic images that reach into the box; their order depends on the
// number of ranks.
std::vector<physics::PlacedDisc> existing_discs(LAMMPS_NS::LAMMPS& engine);

// Prints one line on screen and in the log file, from the first rank.
void say(LAMMPS_NS::LAMMPS& engine, const std::string& line);

}  // namespace mikromakro::styles
