// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// abs(f_t) = mu abs(f_n), mu = 0.5, of forces (f_r, f_phi) of contacts along e_r: 5 of 10 slides in either
// direction, 4.9 of 10 does not, nor does a contact without forces: 2 of 4.
TEST(SlidingContacts, AreThoseAtTheCoulombLimit) {
  const Eigen::Vector2d n{1, 0};
  const Frame frame = disc_between_walls({{n, {-10, 5}}, {n, {-10, -5}}, {n, {-10, -4.9}}, {n, {0, 0}}});
  RingSetup setup = whole_ring({"sliding_fraction"});
  setup.field_options.friction_coefficient = 0.5;
  expect_measured(RingAverage(frame, setup).at("sliding_fraction"), 0.5, few_roundings);
}

}  // namespace
}  // namespace mikromakro
