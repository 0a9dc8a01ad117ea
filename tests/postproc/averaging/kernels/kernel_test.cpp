// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "averaging/kernels/circle_sweep.h"
#include "averaging/kernels/gauss_legendre.h"
#include "averaging/kernels/kernel_references.h"
#include "averaging/kernels/piecewise_polynomial.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

// Promised: 1e-10. For Gauss 2e-11 lies beyond its reach.
TEST(Kernels, IntegrateToOneOverThePlane) {
  for (const NamedKernel& kernel : kernels()) {
    const auto made = kernel.make(0.3);
    const auto ring = [&](double q) { return 2 * std::numbers::pi * q * made->density(q); };
    expect_measured(quick_integral(ring, 0, made->reach()), 1, 1e-10, kernel.name);
  }
}

TEST(Kernels, DensitiesAreThoseOfTheLiterature) {
  for (const NamedKernel& kernel : kernels()) {
    const auto made = kernel.make(0.3);
    for (double q = 0; q < 3; q += 0.037)
      expect_measured(made->density(q), density_reference(kernel.name, q), 1e-14, kernel.name);
  }
}

// e(q) = 2 pi integral of w q dq; a rounding of e over q^2, from q = 0.1 on.
TEST(Kernels, PartWithinADistanceIsTheIntegralOfTheDensity) {
  for (const NamedKernel& kernel : kernels()) {
    const auto made = kernel.make(1);
    const auto ring = [&](double q) { return 2 * std::numbers::pi * q * density_reference(kernel.name, q); };
    for (double q = 0.1; q < made->reach(); q += 0.1)
      expect_measured(made->part_over_square(q) * q * q, quick_integral(ring, 0, q), 1e-13, kernel.name);
    std::vector<double> squares;
    for (double q = 0; q < made->reach(); q += 0.01) squares.push_back(q * q);
    std::vector<double> parts = squares;
    made->parts_over_squares(parts);
    for (std::size_t i = 0; i < squares.size(); ++i)
      expect_measured(parts[i], made->part_over_square(std::sqrt(squares[i])), 1e-12, kernel.name);
    const double at_centre = std::numbers::pi * made->density(0);
    expect_measured(made->part_over_square(0), at_centre, 1e-14);
    expect_measured(made->part_over_square(1e-9), at_centre, 1e-14);
  }
}

// Promised: 1e-11, for Gauss beside the 2e-11 at the end of its reach.
TEST(CirclePart, OfKernelsAnywhere) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr double pi = std::numbers::pi;
  for (const NamedKernel& kernel : kernels()) {
    const auto made = kernel.make(1);
    for (int i = 0; i < 40; ++i) {
      const double R = made->reach() * std::pow(10.0, 2 * uniform(random) - 1);
      const double d = std::fmax(0, R + (2 * uniform(random) - 1) * made->reach());
      const double reference = sector_part(kernel.name, {d, 0, R, -pi, pi});
      expect_measured(CircleSweep(*made, d, R).whole(), reference, 3e-11, kernel.name);
    }
    EXPECT_EQ(CircleSweep(*made, 3 + made->reach(), 3).whole(), 0);
    EXPECT_EQ(CircleSweep(*made, 0.5, 0.5 + made->reach()).whole(), 1);
    const auto within = sector_part(kernel.name, {0, 0, 0.7, -pi, pi});
    expect_measured(CircleSweep(*made, 0, 0.7).whole(), within, 1e-11);
  }
}

TEST(GaussLegendre, IsExactForPolynomialsOfDegreeTwiceItsPointsLessOne) {
  const auto power = [](int n) { return [n](double x) { return std::pow(x, n); }; };
  for (const int n : {0, 5, 9}) expect_measured(gauss_legendre<5>(power(n), 0, 1, 2), 1.0 / (n + 1), 1e-15);
  for (const int n : {12, 19}) expect_measured(gauss_legendre<10>(power(n), 0, 1, 2), 1.0 / (n + 1), 1e-15);
  EXPECT_GT(std::abs(gauss_legendre<5>(power(10), 0, 1, 2) - 1.0 / 11), 1e-7);
  expect_measured(gauss_legendre<5>(power(3), 1, 2, 0.3), 15.0 / 4, 1e-14);
  EXPECT_EQ(gauss_legendre<5>(power(3), 2, 2, 0.3), 0);
}

// The error function has the derivatives that the pieces are made for; a kink does no harm at a break.
TEST(PiecewisePolynomial, MeetsSmoothFunctionsBetweenBreaks) {
  const auto function = [](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2) + std::abs(x); };
  const PiecewisePolynomial table(function, {-7, 0, 7}, 0.7);
  for (double x = -7; x <= 7; x += 0.0123) expect_measured(table(x), function(x), 1e-11);
  expect_measured(table(7), function(7), 1e-11);
}

}  // namespace
}  // namespace mikromakro
