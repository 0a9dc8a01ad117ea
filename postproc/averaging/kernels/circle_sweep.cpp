// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/circle_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "averaging/kernels/part_integral.h"
#include "averaging/volumes/disc_circle_area.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

// 1 - cos(x) for x in [0, pi], to a few ulp: the series at x/4, below pi/4, doubled twice with 1 - cos(2 x) =
// 2 (1 - cos x)(1 + cos x). No function call, so loops over it vectorise.
inline double one_minus_cosine(double x) {
  const double y = 0.0625 * x * x;
  // Factors 1/((2k + 1)(2k + 2)); multiplication is faster than division.
  double series = 1;
  for (const double factor : {1.0 / 240, 1.0 / 182, 1.0 / 132, 1.0 / 90, 1.0 / 56, 1.0 / 30, 1.0 / 12})
    series = 1 - y * factor * series;
  const double once = 0.5 * y * series;
  const double twice = 2 * once * (2 - once);
  return 2 * twice * (2 - twice);
}

}  // namespace

CircleSweep::CircleSweep(const Kernel& kernel, double d, double R)
    : kernel_(kernel), d_(d), R_(R), leaves_(circle_half_angle(d, kernel.reach(), R)) {}

// Direction, seen from the kernel's centre, of the point at angle delta in [0, pi].
double CircleSweep::direction(double delta) const {
  const double half = std::sin(0.5 * delta);
  return std::atan2(R_ * std::sin(delta), (R_ - d_) - 2 * R_ * half * half);
}

// q^2 = (R - d)^2 + 2 R d (1 - cos delta), dtheta = R ((R - d) + d (1 - cos delta)) ddelta/q^2.
double CircleSweep::within_reach(double begin, double end) const {
  const double gap = R_ - d_;
  const auto along = [gap, d = d_, R = R_](double delta, double& square) {
    const double versine = one_minus_cosine(delta);
    square = gap * gap + 2 * R * d * versine;
    return gap + d * versine;
  };
  // The distance changes by at most the smaller of the two radii times the angle; but the sine of the angle
  // itself needs ten points.
  const double speed = std::max(std::min(R_, d_), kernel_.pieces().of_10 / pi);
  return R_ * integral_of_parts(kernel_, begin, end, speed, along);
}

// From begin to end, both in [0, pi].
double CircleSweep::half_arc(double begin, double end) const {
  double part = within_reach(begin, std::min(end, leaves_));
  if (end > leaves_) part += direction(end) - direction(std::max(begin, leaves_));
  return part / (2 * pi);
}

double CircleSweep::arc(double begin, double end) const {
  constexpr double turn = 2 * pi;
  const double shift = turn * std::floor((begin + pi) / turn);
  // Mirrored about the direction of the centre, and about the opposite one, which may lie in between.
  const double first = std::max(begin - shift, -pi);
  const double last = end - shift;
  double part = 0;
  // For equal zeros std::max returns its first argument, which must not be -0: its direction would be -pi.
  if (first < 0) part += half_arc(std::max(0.0, -last), -first);
  if (last > 0 && first < pi) part += half_arc(std::max(0.0, first), std::min(last, pi));
  if (last > pi) {
    const double beyond = std::min(turn - last, pi);
    part += half_arc(std::max(0.0, beyond), pi);
    if (beyond < 0) part += half_arc(0, -beyond);
  }
  return part;
}

double CircleSweep::whole() const {
  if (R_ <= 0 || d_ - R_ >= kernel_.reach()) return 0;
  if (R_ - d_ >= kernel_.reach()) return 1;
  return 2 * half_arc(0, pi);
}

}  // namespace mikromakro
