// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "averaging/kernels/part_integral.h"
#include "averaging/kernels/piecewise_polynomial.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

// Distance along a line at which it leaves the circle of radius `reach`.
double leaves_at(double reach, double h) {
  return std::abs(h) < reach ? std::sqrt((reach - h) * (reach + h)) : 0;
}

// Angle between positions t_1 <= t_2 on a line, seen from the centre; positive if the centre is on the left.
double angle_between(double h, double t_1, double t_2) {
  return std::atan2(h, t_1) - std::atan2(h, t_2);
}

// (1 - exp(-s/2))/s, s = q^2, over the reach of the kernel: on pieces of length 2 in s, ten terms approximate
// it to 1e-13.
const PiecewisePolynomial& gauss_table() {
  static const PiecewisePolynomial table([](double s) { return s < 1e-16 ? 0.5 : -std::expm1(-0.5 * s) / s; },
                                         {0, 50}, 2);
  return table;
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

Kernel::Pieces GaussKernel::pieces() const {
  return {0.7, 1.8, 4};
}

void GaussKernel::parts_over_squares(std::span<double> squares) const {
  static const PiecewisePolynomial& table = gauss_table();
  for (double& square : squares) square = table(square);
}

double GaussKernel::inner_sweep(double h, double t) const {
  return line_part(h, 0, t);
}

double GaussKernel::line_part(double h, double t_1, double t_2) const {
  const double leaves = leaves_at(reach(), h);
  const double first = std::clamp(t_1, -leaves, leaves);
  const double last = std::clamp(t_2, -leaves, leaves);
  const auto along = [&](double t, double& square) {
    square = h * h + t * t;
    return 1.0;
  };
  double part = h * integral_of_parts(*this, first, last, 1, along);
  if (h != 0 && t_1 != first) part += angle_between(h, t_1, first);
  if (h != 0 && t_2 != last) part += angle_between(h, last, t_2);
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

Kernel::Pieces PolynomialKernel::pieces() const {
  return {0.08, 0.25, 0.25};
}

void PolynomialKernel::parts_over_squares(std::span<double> squares) const {
  for (double& square : squares) {
    const double q = std::sqrt(square);
    square = part_[0] + square * (part_[2] + square * part_[4]) +
             q * (part_[1] + square * (part_[3] + square * part_[5]));
  }
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

}  // namespace mikromakro
