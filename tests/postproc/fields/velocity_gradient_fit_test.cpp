// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/velocity_gradient_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "solved_rings.h"

namespace mikromakro {
namespace {

// The paper's fit: v0 = 0.645 * 0.1 * 0.1032, s = 12.7 mm gives D = -0.294 1/s, W = -0.230 1/s at R_i by Eq.
// 9 (docs/conventions.md). Three digits are known.
TEST(VelocityGradientFit, ProfileOfThePaperGivesItsRates) {
  const Eigen::ArrayXd r = Eigen::ArrayXd::LinSpaced(20, 0.1032, 0.18);
  const Rows solved =
      solve_rings(VelocityGradientFit(), r, 0.645 * 0.1 * 0.1032 * (-(r - 0.1032) / 0.0127).exp(), 2);
  EXPECT_NEAR(solved(0, 0), -0.294, 0.0005);
  EXPECT_NEAR(solved(0, 1), -0.230, 0.0005);
}

// Latzel2001 Eqs. 7-9: v = exp(-(r - 1)/s), s = 0.5: D = (dv/dr - v/r)/2 = -v (1/s + 1/r)/2, W = -v (1/s -
// 1/r)/2 in every ring; at r = 2, v = exp(-2): D = -1.25 v, W = -0.75 v.
TEST(VelocityGradientFit, HasItsRatesInEveryRing) {
  const Eigen::ArrayXd r = Eigen::ArrayXd::LinSpaced(5, 1, 2);
  const Rows solved = solve_rings(VelocityGradientFit(), r, (-(r - 1) / 0.5).exp(), 2);
  constexpr double of_fit = 1e-10;  // ExponentialProfile.ExactData...
  expect_measured(solved(0, 0), -1.5, of_fit);
  expect_measured(solved(0, 1), -0.5, of_fit);
  expect_measured(solved(4, 0), -1.25 * std::exp(-2.0), of_fit);
  expect_measured(solved(4, 1), -0.75 * std::exp(-2.0), of_fit);
}

// No exponential through a profile that grows.
TEST(VelocityGradientFit, IsNanWithoutADecayingProfile) {
  const Eigen::ArrayXd r{{1.0, 2.0, 3.0, 4.0}};
  EXPECT_TRUE(std::isnan(solve_rings(VelocityGradientFit(), r, r.exp(), 2)(0, 0)));
}

}  // namespace
}  // namespace mikromakro
