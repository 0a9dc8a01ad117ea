// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/branch_dyad.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "measured_error.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-15;

std::array<double, branch_dyad_sums> sums_of(const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
  std::array<DiscContact, 2> contacts;
  contacts[0].branch = first;
  contacts[1].branch = second;
  std::array<double, branch_dyad_sums> sums{};
  add_branch_dyad(contacts, sums);
  return sums;
}

// (2, 0) and (1, 1): sum l (x) l = (5, 1; 1, 1), determinant 4, inverse (1, -1; -1, 5)/4.
TEST(BranchDyad, AndItsInverse) {
  const auto sums = sums_of({2, 0}, {1, 1});
  EXPECT_EQ(sums, (std::array<double, 3>{5, 1, 1}));
  const Eigen::Matrix2d inverse = inverse_branch_dyad(sums);
  expect_measured(inverse(0, 0), 0.25, rounding);
  expect_measured(inverse(0, 1), -0.25, rounding);
  expect_measured(inverse(1, 0), -0.25, rounding);
  expect_measured(inverse(1, 1), 1.25, rounding);
}

// Branches along x and 1e-5 across: singular values 1 and 1e-10, above 1e-12; 1e-7 across: 1e-14, below.
TEST(BranchDyad, IsSingularBelowItsBound) {
  expect_measured(inverse_branch_dyad(sums_of({1, 0}, {0, 1e-5}))(1, 1) / 1e10, 1, 10 * rounding);
  EXPECT_TRUE(std::isnan(inverse_branch_dyad(sums_of({1, 0}, {0, 1e-7}))(0, 0)));
  EXPECT_TRUE(std::isnan(inverse_branch_dyad(sums_of({0, 0}, {0, 0}))(0, 0)));
}

}  // namespace
}  // namespace mikromakro
