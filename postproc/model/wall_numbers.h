// SPDX-License-Identifier: GPL-2.0-or-later
// What the numbers of a wall's fix mean.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// One number of the vector of a fix, docs/manual/walls.md.
struct WallQuantity {
  std::string_view name;
  std::string_view unit;
  std::string_view text;
};

/// All numbers of `couette/2d`, `biaxial/2d` or `wall/disc`, in their order; empty for other styles.
/// Pressures are in Pa; in N/m if the fix was given no height.
std::span<const WallQuantity> wall_quantities(std::string_view style);

/// The numbers of one wall, as columns named WALL_QUANTITY.
struct WallNumbers {
  std::string wall;
  std::vector<Column> columns;
};

}  // namespace mikromakro
