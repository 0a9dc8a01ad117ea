// SPDX-License-Identifier: GPL-2.0-or-later
// 1/sqrt without the processor's divider.
#pragma once

#include <bit>
#include <cstdint>

namespace mikromakro::physics {

/// 1/sqrt(x) of a normal number x > 0 to some units in the last place: a first guess from half of the
/// exponent, within 3.5 %, and four steps of Newton's method, y (3 - x y^2)/2, each of which squares the
/// error. Only products and differences, so that all processors give the same bits, and several roots side by
/// side take a fraction of a root and a division. Of 0 it is a large number, of NaN it is NaN.
[[gnu::always_inline]] inline double inverse_root(double x) {
  const double half = x / 2;
  double y = std::bit_cast<double>(0x5FE6EB50C7B537A9 - (std::bit_cast<std::int64_t>(x) >> 1));
  for (int k = 0; k < 4; ++k) y *= 1.5 - half * y * y;
  return y;
}

}  // namespace mikromakro::physics
