// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Table 2: kappa.l = l x Delta in the mean of squares; with Delta = Delta_t t, l = 2 n, that is 2
// Delta_t.

// Delta_t = -xi: 2 kappa_r = -0.6 for n = (1, 0), xi = 0.3; 1.2 kappa_r + 1.6 kappa_phi = 0.2 for n = (0.6,
// 0.8), xi = -0.1. Forces do not count where there are springs.
TEST(Curvature, ComesFromTheSprings) {
  const Frame frame = disc_between_walls({{{1, 0}, {-7, 2}, 0.1, 0.3}, {{0.6, 0.8}, {-1, 0}, 0.1, -0.1}});
  RingSetup setup = whole_ring({"curvature"});
  setup.field_options.normal_stiffness = 10;
  const RingAverage average(frame, setup);
  expect_measured(average.at("kappa_zr"), -0.3, few_roundings);
  expect_measured(average.at("kappa_zphi"), 0.35, few_roundings);
}

// Delta_t = f_t/k_n, k_n = 10: f_t = 2 for n = (1, 0): 2 kappa_r = 0.4. n = (0.6, 0.8), t = (-0.8, 0.6), f =
// -4 n - t = (-1.6, -3.8), f_t = -1: 1.2 kappa_r + 1.6 kappa_phi = -0.2.
TEST(Curvature, ComesFromTheForcesWithoutSprings) {
  const Frame frame = disc_between_walls({{{1, 0}, {-7, 2}}, {{0.6, 0.8}, {-1.6, -3.8}}});
  RingSetup setup = whole_ring({"curvature"});
  setup.field_options.normal_stiffness = 10;
  const RingAverage average(frame, setup);
  expect_measured(average.at("kappa_zr"), 0.2, few_roundings);
  expect_measured(average.at("kappa_zphi"), -0.275, few_roundings);
  EXPECT_TRUE(std::isnan(RingAverage(frame, whole_ring({"curvature"})).at("kappa_zr")));
}

}  // namespace
}  // namespace mikromakro
