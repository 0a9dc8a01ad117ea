// SPDX-License-Identifier: GPL-2.0-or-later
// Quadrature of the enclosed fraction of a kernel along a line.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "averaging/kernels/gauss_legendre.h"
#include "averaging/kernels/kernel.h"

namespace mikromakro {

/// One piece of integral_of_parts, with `count` Gauss-Legendre points. Written as passes over all points,
/// which the compiler can vectorise.
template <std::size_t count, typename Along>
double piece_of_parts(const Kernel& kernel, double a, double b, const Along& along) {
  static const GaussLegendre<count> rule;
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  std::array<double, count> factors;
  std::array<double, count> parts;
  for (std::size_t i = 0; i < count; ++i) factors[i] = along(middle + half * rule.nodes[i], parts[i]);
  kernel.parts_over_squares(parts);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += rule.weights[i] * factors[i] * parts[i];
  return sum * half;
}

/// Integral over x from a to b of f(x) e(q)/q^2, where `along(x, square)` returns f(x) and sets square = q^2.
/// The distance q changes by at most `speed` times the change in x. Uses as many points as the kernel needs
/// for 1e-11.
template <typename Along>
double integral_of_parts(const Kernel& kernel, double a, double b, double speed, const Along& along) {
  if (!(b > a)) return 0;
  const Kernel::Pieces longest = kernel.pieces();
  const double length = (b - a) * speed;
  if (length <= longest.of_6) return piece_of_parts<6>(kernel, a, b, along);
  if (length <= longest.of_10) return piece_of_parts<10>(kernel, a, b, along);
  const double pieces = std::ceil(length / longest.of_16);
  const double step = (b - a) / pieces;
  double sum = 0;
  const bool many = longest.of_16 > longest.of_10;
  for (double piece = 0; piece < pieces; ++piece) {
    const double begin = a + piece * step;
    sum += many ? piece_of_parts<16>(kernel, begin, begin + step, along)
                : piece_of_parts<10>(kernel, begin, begin + step, along);
  }
  return sum;
}

}  // namespace mikromakro
