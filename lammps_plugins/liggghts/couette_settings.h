// The arguments of fix couette/2d.
#pragma once

#include <array>
#include <string>

#include "arguments.h"
#include "physics/plane_vector.h"
#include "physics/ring_motion.h"

namespace mikromakro::liggghts {

// A rough ring: the wall discs of a group.
struct RoughRing {
  std::string group;
  int group_bit = 0;
  physics::RingMotion motion;
};

struct CouetteSettings {
  physics::PlaneVector centre;     // m
  std::array<RoughRing, 2> rings;  // inner, outer
  double height = 1.0;             // m; 1 leaves pressures as force per length
};

CouetteSettings parse_couette(LAMMPS_NS::LAMMPS& engine, Arguments& arguments);

}  // namespace mikromakro::liggghts
