// SPDX-License-Identifier: GPL-2.0-or-later
// 1/sqrt(x) without hardware division.
#pragma once

#include <bit>
#include <cstdint>

namespace mikromakro::physics {

/// 1/sqrt(x) of a normal number x > 0 to within a few ulp: an initial guess by halving the exponent, within
/// 3.5 %, and four Newton steps y (3 - x y^2)/2, each of which squares the error. Uses only multiplications
/// and subtractions, so that all processors give the same bits; vectorised, it takes a fraction of the time
/// of a root and a division. Returns a large number for 0 and NaN for NaN.
[[gnu::always_inline]] inline double inverse_root(double x) {
  const double half = x / 2;
  double y = std::bit_cast<double>(0x5FE6EB50C7B537A9 - (std::bit_cast<std::int64_t>(x) >> 1));
  for (int k = 0; k < 4; ++k) y *= 1.5 - half * y * y;
  return y;
}

}  // namespace mikromakro::physics
