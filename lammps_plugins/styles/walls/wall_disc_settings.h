// SPDX-License-Identifier: GPL-2.0-or-later
// Arguments of fix wall/disc.
#pragma once

#include "engine/arguments.h"
#include "physics/walls/smooth_wall.h"

namespace mikromakro::styles {

struct WallDiscSettings {
  int type = 0;              // atom type that supplies the material constants
  physics::SmoothWall wall;  // initial position, and motion
};

WallDiscSettings parse_wall_disc(LAMMPS_NS::LAMMPS& engine, Arguments& arguments);

/// True if two walls differ at most in their motion.
bool same_place(physics::SmoothWall a, const physics::SmoothWall& b);

}  // namespace mikromakro::styles
