// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/scale_numbers.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

TEST(RoundBelow, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_below(7.4), 5);
  EXPECT_DOUBLE_EQ(round_below(4.99), 2);
  EXPECT_DOUBLE_EQ(round_below(0.0013), 0.001);
  for (const double round : {1e-3, 2e5, 5e-7, 1.0, 1000.0}) EXPECT_DOUBLE_EQ(round_below(round), round);
}

TEST(Ticks, AreRoundNumbersWithin) {
  EXPECT_EQ(ticks(0, 9.6, 6), (std::vector<double>{0, 2, 4, 6, 8}));
  EXPECT_EQ(ticks(-1, 1, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(3, 63, 6), (std::vector<double>{10, 20, 30, 40, 50, 60}));
}

TEST(ScaledUnit, BringsNumbersBetweenOneAndAThousand) {
  EXPECT_EQ(scaled_unit(0.0096, "m/s").unit, "mm/s");
  EXPECT_DOUBLE_EQ(scaled_unit(0.0096, "m/s").factor, 1e-3);
  EXPECT_EQ(scaled_unit(1000, "Pa").unit, "kPa");
  EXPECT_EQ(scaled_unit(999, "Pa").unit, "Pa");
  EXPECT_EQ(scaled_unit(0, "Pa").unit, "Pa");
  EXPECT_EQ(scaled_unit(1e-30, "Pa").unit, "Pa");
  EXPECT_EQ(scaled_unit(5000, "").factor, 1);
}

}  // namespace
}  // namespace mikromakro
