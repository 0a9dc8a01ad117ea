// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/velocity_gradient.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "solved_rings.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

// v = 3 - 2 r + 0.5 r^2 on rings of different widths: dv/dr = r - 2 everywhere, also at both ends.
TEST(VelocityGradient, ParabolasAreExactOnRingsOfAnyWidth) {
  const Eigen::ArrayXd r{{1.0, 1.3, 2.1, 2.2, 4.0}};
  const Eigen::ArrayXd v = 3 - 2 * r + 0.5 * r.square();
  const Rows solved = solve_rings(VelocityGradient(), r, v, 3);
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    expect_measured(solved(i, 0), 0.5 * (r[i] - 2 - v[i] / r[i]), rounding);
    expect_measured(solved(i, 1), 0.5 * (r[i] - 2 + v[i] / r[i]), rounding);
    expect_measured(solved(i, 2), 0.5 - solved(i, 1), rounding);
  }
}

// A rigid turn v = 0.5 r: D = 0, W = 0.5, and discs that spin with it have no excess.
TEST(VelocityGradient, RigidRotationDoesNotDeform) {
  const Eigen::ArrayXd r{{1.0, 2.0, 4.0}};
  const Rows solved = solve_rings(VelocityGradient(), r, 0.5 * r, 3);
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    expect_measured(solved(i, 0), 0, rounding);
    expect_measured(solved(i, 1), 0.5, rounding);
    expect_measured(solved(i, 2), 0, rounding);
  }
}

// Halving the rings' width divides the error by 4, inside and at both ends (order 2); v = exp(-r).
TEST(VelocityGradient, ErrorIsOfSecondOrderInTheWidth) {
  const auto error = [](int count, bool at_end) {
    const Eigen::ArrayXd r = Eigen::ArrayXd::LinSpaced(count + 1, 1.0, 3.0);
    const Eigen::ArrayXd slope = slopes(r, (-r).exp());
    const Eigen::Index i = at_end ? 0 : count / 2;
    return std::abs(slope[i] + std::exp(-r[i]));
  };
  // Terms of the next order make the quotient differ from 4: h = 0.025, at most 10 %.
  EXPECT_NEAR(error(40, false) / error(80, false), 4, 0.4);
  EXPECT_NEAR(error(40, true) / error(80, true), 4, 0.4);
}

TEST(VelocityGradient, IsNanForOneRingAndBesideEmptyRings) {
  EXPECT_TRUE(std::isnan(slopes(Eigen::ArrayXd{{1.0}}, Eigen::ArrayXd{{2.0}})[0]));
  EXPECT_EQ(slopes(Eigen::ArrayXd{{1.0, 2.0}}, Eigen::ArrayXd{{5.0, 2.0}})[1], -3);
  const Eigen::ArrayXd slope =
      slopes(Eigen::ArrayXd{{1, 2, 3, 4, 5, 6}}, Eigen::ArrayXd{{1, 2, std::nan(""), 4, 5, 6}});
  EXPECT_TRUE(std::isnan(slope[1]) && std::isnan(slope[2]) && std::isnan(slope[3]));
  EXPECT_EQ(slope[4], 1);
}

}  // namespace
}  // namespace mikromakro
