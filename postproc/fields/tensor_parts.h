// SPDX-License-Identifier: GPL-2.0-or-later
// Trace, deviator and principal direction of a tensor given as four columns.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace mikromakro {

/// Components rr, rphi, phir, phiphi.
using TensorRow = std::span<const double>;

inline double trace(TensorRow t) {
  return t[0] + t[3];
}

/// V_max - V_min of the symmetric part, not halved: sqrt((V_rr - V_phiphi)^2 + (V_rphi + V_phir)^2).
inline double deviator(TensorRow t) {
  return std::hypot(t[0] - t[3], t[1] + t[2]);
}

/// Whether a trace or a deviator of `t` is 0 to within the rounding of the sums it was computed from.
inline bool is_rounding(double part, TensorRow t) {
  constexpr double of_sums = 1e-12;
  return std::abs(part) <= of_sums * std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + t[3] * t[3]);
}

/// Direction of the largest principal value of the symmetric part (with `of_smallest`, of the smallest),
/// counter-clockwise from e_r, degrees in (-90, 90]. nan if the tensor is isotropic to rounding.
inline double principal_angle(TensorRow t, bool of_smallest) {
  if (!(deviator(t) > 0) || is_rounding(deviator(t), t)) return std::numeric_limits<double>::quiet_NaN();
  const double side = of_smallest ? -1 : 1;
  const double degrees = 90 / std::numbers::pi * std::atan2(side * (t[1] + t[2]), side * (t[0] - t[3]));
  // atan2 returns -pi for arguments -0 and x < 0.
  return degrees <= -90 ? 90 : degrees;
}

}  // namespace mikromakro
