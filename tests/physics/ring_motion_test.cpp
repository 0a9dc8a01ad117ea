// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/motion/ring_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "physics/motion/step_clock.h"

namespace mikromakro::physics {
namespace {

const RadiusCourse compaction{0.328, 0.2524, 2.0};

TEST(RadiusCourse, GoesFromStartToEndAndStaysThere) {
  EXPECT_DOUBLE_EQ(compaction.radius(0.0), 0.328);
  EXPECT_DOUBLE_EQ(compaction.radius(1.0), 0.5 * (0.328 + 0.2524));  // cos(pi/2) = 0
  EXPECT_EQ(compaction.radius(2.0), 0.2524);
  EXPECT_EQ(compaction.radius(7.0), 0.2524);
  EXPECT_EQ(compaction.rate(0.0), 0.0);
  EXPECT_EQ(compaction.rate(2.0), 0.0);
}

// A central difference is off by h^2/6 of the third derivative, here 0.5 * 0.0756 * (pi/2)^3: below 2.5e-10
// at h = 1e-4.
TEST(RadiusCourse, RateIsTheDerivative) {
  const double h = 1e-4;
  for (const double t : {0.3, 1.0, 1.7}) {
    const double difference = (compaction.radius(t + h) - compaction.radius(t - h)) / (2 * h);
    EXPECT_NEAR(compaction.rate(t), difference, 3e-10);
  }
}

TEST(RadiusCourse, WithoutDurationIsConstant) {
  const RadiusCourse fixed{0.1032, 0.1032, 0.0};
  EXPECT_EQ(fixed.radius(0.0), 0.1032);
  EXPECT_EQ(fixed.rate(0.0), 0.0);
}

// Reference in long double (64 bits of mantissa). Two roundings of theta = 0.4, one each of cos, sin, R and
// the products: a few 1e-17 m on 0.1 m.
TEST(WallDisc, IsOnTheExactAngleAfterManySteps) {
  const StepClock clock(0.0, 500, 4e-5);
  const RingMotion motion{{0.1032, 0.1032, 0.0}, 0.1, 0.0};
  const PlaneVector reference{std::cos(1.2), std::sin(1.2)};
  const WallDiscState disc = wall_disc_state(motion.at(clock.time_at(100500)), reference);
  const long double angle = 1.2L + 0.1L * 100000 * static_cast<long double>(4e-5);
  EXPECT_NEAR(disc.position.x, static_cast<double>(0.1032L * std::cos(angle)), 1e-16);
  EXPECT_NEAR(disc.position.y, static_cast<double>(0.1032L * std::sin(angle)), 1e-16);
}

// Central differences again: third derivatives are of order omega^3 R and (pi/T)^3 (R_start - R_end)/2.
TEST(WallDisc, VelocityIsTheDerivativeOfThePosition) {
  const RingMotion motion{compaction, 3.0, 0.5};
  const PlaneVector reference{0.6, -0.8};
  const double h = 1e-5;
  for (const double t : {0.2, 1.1, 1.9}) {
    const WallDiscState before = wall_disc_state(motion.at(t - h), reference);
    const WallDiscState now = wall_disc_state(motion.at(t), reference);
    const WallDiscState after = wall_disc_state(motion.at(t + h), reference);
    EXPECT_NEAR(now.velocity.x, (after.position.x - before.position.x) / (2 * h), 3e-10);
    EXPECT_NEAR(now.velocity.y, (after.position.y - before.position.y) / (2 * h), 3e-10);
  }
}

TEST(WallDisc, ReferenceDirectionUndoesTheRotation) {
  const RingState ring = RingMotion{{0.25, 0.25, 0.0}, 0.7, 0.3}.at(11.0);
  const PlaneVector reference{std::cos(-2.0), std::sin(-2.0)};
  const PlaneVector found = reference_direction(ring, wall_disc_state(ring, reference).position);
  EXPECT_NEAR(found.x, reference.x, 4e-16);  // rounding
  EXPECT_NEAR(found.y, reference.y, 4e-16);
}

// 1000 steps of 4e-5 s, then steps of 1e-5 s: 0.04 + 500 * 1e-5 = 0.045 s.
TEST(StepClock, FollowsAChangeOfTheTimeStep) {
  StepClock clock(0.0, 0, 4e-5);
  clock.change_step_length(1000, 1e-5);
  EXPECT_DOUBLE_EQ(clock.time_at(1000), 0.04);
  EXPECT_DOUBLE_EQ(clock.time_at(1500), 0.045);
}

TEST(StepClock, FollowsANewCountOfSteps) {
  StepClock clock(1.0, 200, 0.5);
  const double time = clock.time_at(300);
  clock.shift_steps(-300);
  EXPECT_EQ(clock.time_at(0), time);
}

}  // namespace
}  // namespace mikromakro::physics
