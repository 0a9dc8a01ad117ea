// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/walls/bottom_friction.h"

#include <gtest/gtest.h>

namespace mikromakro::physics {
namespace {

TEST(BottomFriction, OpposesTheVelocityWithAForceThatDoesNotDependOnIt) {
  // 10 N along -(3, 4)/5.
  for (const double speed : {0.5, 5.0, 5e6}) {
    const auto f = bottom_friction(10, {0.6 * speed, -0.8 * speed}, 0.1);
    EXPECT_NEAR(f.x, -6, 2e-15);  // rounding of two products and a quotient
    EXPECT_NEAR(f.y, 8, 2e-15);
  }
}

TEST(BottomFriction, FallsLinearlyToZeroBelowTheVelocityOfRegularisation) {
  EXPECT_DOUBLE_EQ(bottom_friction(10, {0.05, 0}, 0.1).x, -5);
  EXPECT_DOUBLE_EQ(bottom_friction(10, {0.1, 0}, 0.1).x, -10);  // continuous
  EXPECT_EQ(bottom_friction(10, {0, 0}, 0.1).x, 0);
  EXPECT_EQ(bottom_friction(10, {0, 0}, 0.1).y, 0);
}

TEST(BottomFriction, TakesMuGDtFromTheVelocityInAStep) {
  EXPECT_DOUBLE_EQ(velocity_lost_in_a_step(0.5, 10, 0.125), 0.625);
}

}  // namespace
}  // namespace mikromakro::physics
