#pragma once

namespace mikromakro::physics {

// A vector of the plane, in the unit of what it holds.
struct PlaneVector {
  double x = 0.0;
  double y = 0.0;
};

}  // namespace mikromakro::physics
