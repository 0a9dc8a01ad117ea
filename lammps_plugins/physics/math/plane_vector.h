// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace mikromakro::physics {

// Two-dimensional vector, in the unit of the quantity it holds.
struct PlaneVector {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const PlaneVector&) const = default;
};

}  // namespace mikromakro::physics
