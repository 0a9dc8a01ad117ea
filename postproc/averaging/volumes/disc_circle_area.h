// SPDX-License-Identifier: GPL-2.0-or-later
// Intersection area of a disc and a circle, to rounding of the disc's area.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mikromakro {

/// theta - sin(theta) cos(theta): area of the segment of half-angle theta of the unit circle, theta in [0,
/// pi]. Small angles use the series of (x - sin x)/2, x = 2 theta, to avoid cancellation.
inline double segment_area(double theta) {
  const double x = 2 * theta;
  if (x > 1) return 0.5 * (x - std::sin(x));
  const double y = x * x;
  // x^3/12 (1 - y/20 (1 - y/42 (...))), factors 2k (2k + 1); the first omitted term is below 1e-17 at x = 1.
  double bracket = 1;
  for (const double factor : {272.0, 210.0, 156.0, 110.0, 72.0, 42.0, 20.0})
    bracket = 1 - y / factor * bracket;
  return x * y / 12 * bracket;
}

/// Half-angle of the circle's arc inside the disc, in [0, pi]. Never throws.
inline double circle_half_angle(double d, double a, double R) {
  const double gap = d - R;
  if (std::abs(gap) >= a) return 0;
  const double circle_side = std::max(d - a + R, 0.0);
  return 2 * std::atan2(std::sqrt((a - gap) * (a + gap)), std::sqrt((a + d + R) * circle_side));
}

/// Area of the intersection of a disc of radius a > 0, with its centre at distance d >= 0 from the origin,
/// and the circle of radius R >= 0 about the origin; in units of a^2. Never throws.
///
/// Two segments on the common chord: A = a^2 s(alpha) + R^2 s(beta), with s as above. Half-angles from
///   tan^2(alpha/2) = (R + a - d)(R - a + d) / ((a + d + R)(a + d - R)), beta with a and R exchanged,
/// in which every difference that may be small is a separate factor, computed from d - R (exact if d and R
/// are close).
inline double disc_circle_area(double d, double a, double R) {
  const double gap = d - R;
  if (gap >= a) return 0;
  if (R <= 0) return 0;
  if (gap <= -a) return std::numbers::pi * a * a;
  const double near_side = a - gap;                     // a + R - d
  const double far_side = a + gap;                      // a + d - R
  const double circle_side = std::max(d - a + R, 0.0);  // 0: the circle lies inside the disc, beta = pi
  const double perimeter = a + d + R;
  const double alpha = 2 * std::atan2(std::sqrt(near_side * circle_side), std::sqrt(perimeter * far_side));
  const double beta = circle_half_angle(d, a, R);
  return a * a * segment_area(alpha) + R * R * segment_area(beta);
}

/// Fraction of the disc's area, in [0, 1], between the circles of radii inner <= outer.
inline double disc_ring_fraction(double d, double a, double inner, double outer) {
  return (disc_circle_area(d, a, outer) - disc_circle_area(d, a, inner)) / (std::numbers::pi * a * a);
}

}  // namespace mikromakro
