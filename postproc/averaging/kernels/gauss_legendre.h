// SPDX-License-Identifier: GPL-2.0-or-later
// Gauss-Legendre quadrature.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mikromakro {

/// Nodes in (-1, 1) and weights (summing to 2) of the rule with `count` points, exact for polynomials of
/// degree 2 count - 1.
template <std::size_t count>
struct GaussLegendre {
  std::array<double, count> nodes;
  std::array<double, count> weights;

  GaussLegendre() {
    for (std::size_t i = 0; i < count; ++i) {
      // Tricomi's estimate of the root, then Newton's method, which doubles the correct digits per step.
      double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
      double slope = 1;
      for (int step = 0; step < 6; ++step) {
        double before = 1;
        double value = x;
        for (std::size_t k = 2; k <= count; ++k) {
          const auto degree = static_cast<double>(k);
          const double next = ((2 * degree - 1) * x * value - (degree - 1) * before) / degree;
          before = value;
          value = next;
        }
        slope = count * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Integral of f from a to b, on equal pieces no longer than `longest`.
template <std::size_t count, typename Function>
double gauss_legendre(const Function& f, double a, double b, double longest) {
  static const GaussLegendre<count> rule;
  if (!(b > a)) return 0;
  const double pieces = std::fmax(1, std::ceil((b - a) / longest));
  const double half = 0.5 * (b - a) / pieces;
  double sum = 0;
  for (double piece = 0; piece < pieces; ++piece) {
    const double middle = a + (2 * piece + 1) * half;
    for (std::size_t i = 0; i < count; ++i) sum += rule.weights[i] * f(middle + half * rule.nodes[i]);
  }
  return sum * half;
}

}  // namespace mikromakro
