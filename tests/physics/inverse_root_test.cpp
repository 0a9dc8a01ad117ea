// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/math/inverse_root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace mikromakro::physics {
namespace {

/// Four steps of Newton's method end at rounding: within 3 epsilon (measured: 2.0; three steps leave 1e-11).
TEST(InverseRoot, IsThatOfTheLibraryToRounding) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-40, 40);
  double largest = 0;
  for (int k = 0; k < 1000000; ++k) {
    const double x = std::exp2(exponent(random));
    largest = std::max(largest, std::abs(inverse_root(x) * std::sqrt(x) - 1));
  }
  EXPECT_LT(largest, 3 * std::numeric_limits<double>::epsilon());
}

TEST(InverseRoot, TellsWhatIsNoNumber) {
  EXPECT_TRUE(std::isnan(inverse_root(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(0 * inverse_root(0), 0);
}

}  // namespace
}  // namespace mikromakro::physics
