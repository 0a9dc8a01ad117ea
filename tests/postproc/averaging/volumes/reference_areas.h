// SPDX-License-Identifier: GPL-2.0-or-later
// Areas of a disc in rectangles and sectors by quadrature in extended precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mikromakro {

using Long = long double;

/// Integral of f from a to b by the double exponential rule (Takahasi1974), which does not mind
/// roots at the ends: to about 1e-17 of (b - a) max f where f is analytic between them.
template <typename Function>
Long integral(const Function& f, Long a, Long b) {
  constexpr Long step = 1.0L / 32;
  constexpr Long half_pi = std::numbers::pi_v<Long> / 2;
  Long sum = 0;
  for (int k = -128; k <= 128; ++k) {
    const Long s = half_pi * std::sinh(k * step);
    const Long weight = half_pi * std::cosh(k * step) / (std::cosh(s) * std::cosh(s));
    // From the nearer end, since 1 - tanh would lose its digits.
    const Long part = 1 / (std::exp(2 * std::abs(s)) + 1);
    const Long x = k < 0 ? a + (b - a) * part : b - (b - a) * part;
    sum += weight * f(x);
  }
  return sum * step * (b - a) / 2;
}

/// The same with breaks, in any order, those outside of [a, b] and nan left out.
template <typename Function>
Long integral(const Function& f, Long a, Long b, std::vector<Long> breaks) {
  std::erase_if(breaks, [&](Long x) { return !(x > a && x < b); });
  breaks.insert(breaks.end(), {a, b});
  std::sort(breaks.begin(), breaks.end());
  Long sum = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i) sum += integral(f, breaks[i - 1], breaks[i]);
  return sum;
}

/// X from left to right, Y from bottom to top, by the radius of a disc around 0.
struct Rectangle {
  double left, right, bottom, top;
};

/// Area of the disc in the rectangle by chords at x = sin(theta), cut off at bottom and top, with breaks
/// where the cut sets in.
inline Long rectangle_reference(const Rectangle& r) {
  const auto angle = [](Long x) { return std::asin(std::clamp(x, -1.0L, 1.0L)); };
  std::vector<Long> breaks;
  for (const Long y : {Long{r.bottom}, Long{r.top}}) {
    if (std::abs(y) >= 1) continue;
    breaks.push_back(std::acos(std::abs(y)));
    breaks.push_back(-std::acos(std::abs(y)));
  }
  const auto chord = [&](Long theta) {
    const Long c = std::cos(theta);
    return std::max(0.0L, std::min<Long>(r.top, c) - std::max<Long>(r.bottom, -c)) * c;
  };
  return integral(chord, angle(r.left), angle(r.right), breaks);
}

/// A disc of radius 1 at (d, 0), and the sector inner <= r < outer, begin <= phi < end.
struct Sector {
  Long d, inner, outer, begin, end;
};

/// Area by r times the angle that the arc at r within the disc (half-angle by the law of cosines) and the
/// sector have in common, with breaks where the circle's rim crosses the sector's straight sides.
inline Long sector_reference(const Sector& s) {
  constexpr Long pi = std::numbers::pi_v<Long>;
  const Long d = s.d;
  const auto half_angle = [&](Long r) {
    if (r + d <= 1) return pi;
    return std::acos(std::clamp((r * r + (d - 1) * (d + 1)) / (2 * r * d), -1.0L, 1.0L));
  };
  const auto common = [&](Long r) {
    const Long half = half_angle(r);
    Long sum = 0;
    for (int turn = -2; turn <= 2; ++turn) {
      const Long shift = 2 * pi * turn;
      sum += std::max(0.0L, std::min(half, s.end + shift) - std::max(-half, s.begin + shift));
    }
    return r * sum;
  };
  std::vector<Long> breaks = {d - 1, 1 - d};
  for (const Long angle : {s.begin, s.end}) {
    const Long root = std::sqrt(1 - d * d * std::sin(angle) * std::sin(angle));
    breaks.push_back(d * std::cos(angle) - root);
    breaks.push_back(d * std::cos(angle) + root);
  }
  const Long low = std::max({s.inner, d - 1, 0.0L});
  const Long high = std::min(s.outer, d + 1);
  return high > low ? integral(common, low, high, breaks) : 0;
}

}  // namespace mikromakro
