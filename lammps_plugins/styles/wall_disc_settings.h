// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of fix wall/disc.
#pragma once

#include "arguments.h"
#include "physics/smooth_wall.h"

namespace mikromakro::styles {

struct WallDiscSettings {
  int type = 0;              // whose material constants the wall has
  physics::SmoothWall wall;  // where it stands at first, and how it moves
};

WallDiscSettings parse_wall_disc(LAMMPS_NS::LAMMPS& engine, Arguments& arguments);

/// Whether two walls are the same but for their motion.
bool same_place(physics::SmoothWall a, const physics::SmoothWall& b);

}  // namespace mikromakro::styles
