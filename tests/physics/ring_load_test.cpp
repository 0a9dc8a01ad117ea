// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/walls/ring_load.h"

#include <gtest/gtest.h>

#include <numbers>

namespace mikromakro::physics {
namespace {

// A wall disc at (0, 2) with the force (3, -4) and the own torque 0.5:
// torque = 0 * (-4) - 2 * 3 + 0.5 = -5.5, outward force = f_y = -4.
TEST(RingLoad, SumsMomentAndRadialForce) {
  RingLoad load;
  load.add({0.0, 2.0}, {3.0, -4.0}, 0.5);
  EXPECT_DOUBLE_EQ(load.torque, -5.5);
  EXPECT_DOUBLE_EQ(load.outward_force, -4.0);
  load.add({-2.0, 0.0}, {-1.0, 1.0}, 0.0);  // torque -2 * 1 - 0, outward 1
  EXPECT_DOUBLE_EQ(load.torque, -7.5);
  EXPECT_DOUBLE_EQ(load.outward_force, -3.0);
}

// Discs push the wheel inwards and the outer ring outwards: both are compression. 3/(2 pi 2 * 0.5) = 3/(2
// pi).
TEST(RingPressure, IsPositiveInCompression) {
  const double expected = 3.0 / (2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(ring_pressure(RingSide::inner, {0.0, -3.0}, 2.0, 0.5), expected);
  EXPECT_DOUBLE_EQ(ring_pressure(RingSide::outer, {0.0, 3.0}, 2.0, 0.5), expected);
}

// A torque of -5 N m resists a wheel that turns counter-clockwise: it feeds power in.
TEST(RingPower, IsPositiveAgainstResistance) {
  EXPECT_DOUBLE_EQ(ring_power({-5.0, 0.0}, 0.1), 0.5);
}

// 2 pi 103.2/5.3 = 122.34; 2 pi 252.4/5.3 = 299.22.
TEST(RingCount, RoundsTheCircumferenceOverThePitch) {
  EXPECT_EQ(ring_count(0.1032, 0.0053), 122);
  EXPECT_EQ(ring_count(0.2524, 0.0053), 299);
}

}  // namespace
}  // namespace mikromakro::physics
