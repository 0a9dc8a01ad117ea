// SPDX-License-Identifier: GPL-2.0-or-later
// Arguments of fix couette/2d.
#pragma once

#include <array>
#include <string>

#include "engine/arguments.h"
#include "physics/math/plane_vector.h"
#include "physics/motion/ring_motion.h"

namespace mikromakro::styles {

// Rough ring: the wall discs of a group. Smooth ring: a circular wall with the material of an atom type.
struct Ring {
  std::string group;
  int group_bit = 0;  // smooth: 0, no discs
  int type = 0;       // rough: 0
  physics::RingMotion motion;

  [[nodiscard]] bool smooth() const { return type > 0; }
};

struct CouetteSettings {
  physics::PlaneVector centre;  // m
  std::array<Ring, 2> rings;    // inner, outer
  double height = 1.0;          // m; 1 leaves pressures as force per length
};

CouetteSettings parse_couette(LAMMPS_NS::LAMMPS& engine, Arguments& arguments);

}  // namespace mikromakro::styles
