// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace mikromakro::physics {

// A vector of the plane, in the unit of what it holds.
struct PlaneVector {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const PlaneVector&) const = default;
};

}  // namespace mikromakro::physics
