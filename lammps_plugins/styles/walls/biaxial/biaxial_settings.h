// SPDX-License-Identifier: GPL-2.0-or-later
// Arguments of fix biaxial/2d and of its fix_modify.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/arguments.h"

namespace mikromakro::styles {

enum class BiaxialSide { left, right, bottom, top };
inline const std::array<std::string, 4> biaxial_sides = {"left", "right", "bottom", "top"};

// How a wall moves along its normal.
struct WallControl {
  enum class Kind { fixed, cosine, rate, stress };
  Kind kind = Kind::fixed;
  double target = 0.0;  // cosine: end (m); rate: velocity (m/s); stress: pressure (N/m, or Pa with a height)
  double duration = 0.0;  // cosine: s
  double mass = 0.0;      // stress: kg
  double damping = 0.0;   // stress: kg/s

  bool operator==(const WallControl&) const = default;
};

struct BiaxialWallSettings {
  double position = 0.0;  // initial (m)
  WallControl control;
  int type = 0;  // atom type that supplies the material constants
};

struct BiaxialSettings {
  std::array<BiaxialWallSettings, 4> walls;  // left, right, bottom, top
  double height = 1.0;                       // m; 1 leaves pressures as force per length
};

BiaxialSettings parse_biaxial(LAMMPS_NS::LAMMPS& engine, Arguments& arguments);

// Changes by fix_modify; the walls keep their positions.
struct BiaxialChange {
  std::array<std::optional<WallControl>, 4> controls;
  bool reset = false;
};
BiaxialChange parse_biaxial_change(Arguments& arguments);

}  // namespace mikromakro::styles
