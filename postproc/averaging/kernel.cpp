#include "averaging/kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "averaging/disc_circle_area.h"
#include "averaging/gauss_legendre.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

// Distance along a line at which it leaves the circle of radius `reach`.
double leaves_at(double reach, double h) {
  return std::abs(h) < reach ? std::sqrt((reach - h) * (reach + h)) : 0;
}

// Angle between two places t_1 <= t_2 on a line, as seen from the centre; positive where it is on the left.
double angle_between(double h, double t_1, double t_2) {
  return std::atan2(h, t_1) - std::atan2(h, t_2);
}

// Direction, from the kernel's centre, of the point at the angle delta in [0, pi] of a circle.
double direction(double d, double R, double delta) {
  const double half = std::sin(0.5 * delta);
  return std::atan2(R * std::sin(delta), (R - d) - 2 * R * half * half);
}

// From begin to end, both in [0, pi].
double half_arc_part(const Kernel& kernel, double d, double R, double begin, double end) {
  const double leaves = circle_half_angle(d, kernel.reach(), R);
  const auto rate = [&](double delta) {
    const double half = std::sin(0.5 * delta);
    const double q = std::sqrt((R - d) * (R - d) + 4 * R * d * half * half);
    return kernel.part_over_square(q) * R * ((R - d) + 2 * d * half * half);
  };
  // The distance changes by no more than the smaller of both radii times the angle.
  const double longest = kernel.smooth_length() / std::min(R, d);
  double part = gauss_legendre<10>(rate, begin, std::min(end, leaves), longest);
  if (end > leaves) part += direction(d, R, end) - direction(d, R, std::max(begin, leaves));
  return part / (2 * pi);
}

}  // namespace

double Kernel::line_sweep(double h, double t) const {
  if (h == 0) return 0;
  const double x = std::abs(t);
  const double leaves = leaves_at(reach(), h);
  double sweep = inner_sweep(h, std::min(x, leaves));
  if (x > leaves) sweep += angle_between(h, leaves, x) / (2 * pi);
  return std::copysign(1.0, t) * sweep;
}

double Kernel::line_part(double h, double t_1, double t_2) const {
  return line_sweep(h, t_2) - line_sweep(h, t_1);
}

double GaussKernel::density(double q) const {
  return std::exp(-0.5 * q * q) / (2 * pi);
}

double GaussKernel::part_over_square(double q) const {
  const double square = q * q;
  return square < 1e-16 ? 0.5 : -std::expm1(-0.5 * square) / square;
}

double GaussKernel::inner_sweep(double h, double t) const {
  return line_part(h, 0, t);
}

double GaussKernel::line_part(double h, double t_1, double t_2) const {
  const double leaves = leaves_at(reach(), h);
  const auto rate = [&](double t) { return part_over_square(std::sqrt(h * h + t * t)); };
  const double first = std::clamp(t_1, -leaves, leaves);
  const double last = std::clamp(t_2, -leaves, leaves);
  double part = h * gauss_legendre<10>(rate, first, last, smooth_length());
  if (h != 0) part += angle_between(h, t_1, first) + angle_between(h, last, t_2);
  return part / (2 * pi);
}

PolynomialKernel::PolynomialKernel(const Coefficients& coefficients, double width)
    : Kernel(width), density_(coefficients), part_(2 * pi * coefficients / Coefficients::LinSpaced(2, 7)) {}

double PolynomialKernel::density(double q) const {
  if (q >= 1) return 0;
  double sum = 0;
  for (Eigen::Index k = density_.size(); k-- > 0;) sum = sum * q + density_[k];
  return sum;
}

double PolynomialKernel::part_over_square(double q) const {
  double sum = 0;
  for (Eigen::Index k = part_.size(); k-- > 0;) sum = sum * q + part_[k];
  return sum;
}

// Sum of e_k I_k, I_k = integral of (h^2 + t^2)^(k/2) dt = (t q^k + k h^2 I_(k-2))/(k + 1).
double PolynomialKernel::inner_sweep(double h, double t) const {
  const double square = h * h;
  const double q = std::sqrt(square + t * t);
  double even = t;
  double odd = 0.5 * (t * q + square * std::log((t + q) / std::abs(h)));
  double sum = part_[0] * even + part_[1] * odd;
  double power = q;
  for (Eigen::Index k = 2; k < part_.size(); k += 2) {
    const auto degree = static_cast<double>(k);
    power *= q;
    even = (t * power + degree * square * even) / (degree + 1);
    power *= q;
    odd = (t * power + (degree + 1) * square * odd) / (degree + 2);
    sum += part_[k] * even + part_[k + 1] * odd;
  }
  return h * sum / (2 * pi);
}

PolynomialKernel::Coefficients lucy() {
  return 5 / pi * PolynomialKernel::Coefficients{1, 0, -6, 8, -3, 0};
}

PolynomialKernel::Coefficients wendland() {
  return 7 / pi * PolynomialKernel::Coefficients{1, 0, -10, 20, -15, 4};
}

double arc_part(const Kernel& kernel, double d, double R, double begin, double end) {
  constexpr double turn = 2 * pi;
  const double shift = turn * std::floor((begin + pi) / turn);
  // Mirrored at the direction of the centre, and at the opposite one, which may lie in between.
  const double first = std::max(begin - shift, -pi);
  const double last = end - shift;
  double part = 0;
  if (first < 0) part += half_arc_part(kernel, d, R, std::max(-last, 0.0), -first);
  if (last > 0 && first < pi) part += half_arc_part(kernel, d, R, std::max(first, 0.0), std::min(last, pi));
  if (last > pi) {
    const double beyond = std::min(turn - last, pi);
    part += half_arc_part(kernel, d, R, std::max(beyond, 0.0), pi);
    if (beyond < 0) part += half_arc_part(kernel, d, R, 0, -beyond);
  }
  return part;
}

double circle_part(const Kernel& kernel, double d, double R) {
  if (R <= 0 || d - R >= kernel.reach()) return 0;
  if (R - d >= kernel.reach()) return 1;
  return 2 * half_arc_part(kernel, d, R, 0, pi);
}

}  // namespace mikromakro
