// SPDX-License-Identifier: GPL-2.0-or-later
// z component of a cross product in the plane.
#pragma once

#include <Eigen/Core>

namespace mikromakro {

/// (a x b)_z = a_1 b_2 - a_2 b_1; independent of the (right-handed) basis of the plane.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace mikromakro
