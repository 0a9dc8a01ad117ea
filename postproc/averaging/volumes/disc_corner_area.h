// SPDX-License-Identifier: GPL-2.0-or-later
// Areas of a disc cut off at corners, from which exact areas in rectangles and sectors are computed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "averaging/volumes/disc_circle_area.h"

namespace mikromakro {

// By Green's theorem, the area of a disc (centre 0, radius 1) inside a closed outline is the integral of
// min(1, |p|^2)/2 dtheta along the outline, with theta the direction of p seen from the centre: the triangles
// and segments below the outline where it runs inside the disc, a circular sector of the same angle where it
// runs outside. It is continuous in all arguments, wherever the centre lies. The sweeps below are such
// integrals in closed form, odd in their end point; a piece of an outline is the difference of two.

/// Along a straight line from the point nearest to the centre over a length `t`; the line passes at distance
/// `h` with the centre on its left (negative: on its right). Both in units of the disc's radius, the result
/// in units of its square; t may be infinite. Never throws.
inline double line_sweep(double h, double t) {
  const double leaves = std::abs(h) < 1 ? std::sqrt((1 - h) * (1 + h)) : 0;
  const double x = std::abs(t);
  if (x <= leaves) return 0.5 * h * t;
  const double outside = std::atan2(h, leaves) - std::atan2(h, x);
  return std::copysign(0.5, t) * (h * leaves + outside);
}

/// Area of the unit disc about 0 with X < x and Y < y; infinite x or y give a half-plane or the whole plane.
/// To rounding of the disc's area. Never throws.
inline double disc_quadrant_area(double x, double y) {
  constexpr double pi = std::numbers::pi;
  constexpr double far = std::numeric_limits<double>::infinity();
  if (x <= -1 || y <= -1) return 0;
  if (x >= 1) return pi / 2 + 2 * line_sweep(y, far);
  if (y >= 1) return pi / 2 + 2 * line_sweep(x, far);
  if (x < 0 && y < 0 && x * x + y * y >= 1) return 0;
  const double up = line_sweep(x, y) + line_sweep(x, far);
  const double back = line_sweep(y, x) + line_sweep(y, far);
  return std::max(pi / 4 + up + back, 0.0);
}

/// Along the circle of radius R >= 0 about an origin at distance d from the disc's centre, counter-clockwise
/// over the angle `delta` in [-pi, pi] from the direction of that centre; a > 0 is the disc's radius. In
/// units of a^2. Never throws.
///
/// Inside the disc: R/2 ((R - d) delta + d (delta - sin delta)), the second difference by its series.
inline double arc_sweep(double d, double a, double R, double delta) {
  const double x = std::min(std::abs(delta), std::numbers::pi);
  const double leaves = circle_half_angle(d, a, R);
  const auto direction = [&](double angle) {
    const double half = std::sin(0.5 * angle);
    return std::atan2(R * std::sin(angle), (R - d) - 2 * R * half * half);
  };
  const double inside = std::min(x, leaves);
  double sweep = 0.5 * R * ((R - d) * inside + 2 * d * segment_area(0.5 * inside));
  if (x > leaves) sweep += 0.5 * a * a * (direction(x) - direction(leaves));
  return delta < 0 ? -sweep : sweep;
}

/// The corner at radius R and angle `delta` (as above, but any number of turns) of sectors of rings about the
/// origin: the area of the disc in R_1 <= r < R_2, delta_1 <= delta < delta_2 is
///   c(R_2, delta_2) - c(R_2, delta_1) - c(R_1, delta_2) + c(R_1, delta_1).
/// In units of a^2. Never throws.
inline double sector_corner(double d, double a, double R, double delta) {
  constexpr double turn = 2 * std::numbers::pi;
  const double turns = std::nearbyint(delta / turn);
  // The same rounded angle for arc and line, so that they meet at the corner.
  const double rest = delta - turn * turns;
  const double half = std::sin(0.5 * rest);
  const double along = (R - d) + 2 * d * half * half;
  const double left = -d * std::sin(rest);
  const double whole_turns = turns == 0 ? 0 : turns * disc_circle_area(d, a, R);
  return whole_turns + arc_sweep(d, a, R, rest) - a * a * line_sweep(left / a, along / a);
}

}  // namespace mikromakro
