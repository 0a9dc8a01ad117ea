// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/disc_circle_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measured_error.h"

namespace mikromakro {
namespace {

using Long = long double;
const Long pi = std::numbers::pi_v<Long>;

// Reference: the textbook lens formula in extended precision (eps = 1e-19). The angles of a sliver lose half
// of their digits there (acos near 1), but the error of the area is only (error of the angle) times
// (angle)^2: of the order of eps R/a of the disc's area, below 1e-16 for R/a up to 100. It shares no formula
// with the code under test.
Long lens(Long d, Long a, Long R) {
  if (d >= a + R) return 0;
  if (d + a <= R) return pi * a * a;
  if (d + R <= a) return pi * R * R;
  const Long alpha = std::acos(std::min(Long{1}, (d + (a - R) * (a + R) / d) / (2 * a)));
  const Long beta = std::acos(std::min(Long{1}, (d + (R - a) * (R + a) / d) / (2 * R)));
  return a * a * (alpha - std::sin(alpha) * std::cos(alpha)) +
         R * R * (beta - std::sin(beta) * std::cos(beta));
}

double error_by_disc_area(double d, double a, double R) {
  return static_cast<double>(std::abs(disc_circle_area(d, a, R) - lens(d, a, R)) / (pi * a * a));
}

// Promised for single areas: 1e-13 of the disc's area; the formula is good to a few roundings of it.
constexpr double tolerance = 1e-13;

TEST(DiscCircleArea, KnowsTheCasesWithoutCrossing) {
  EXPECT_EQ(disc_circle_area(5, 1, 3), 0);                                // apart
  EXPECT_EQ(disc_circle_area(4, 1, 3), 0);                                // touching from outside
  EXPECT_DOUBLE_EQ(disc_circle_area(1, 1, 3), std::numbers::pi);          // disc within the circle
  EXPECT_DOUBLE_EQ(disc_circle_area(2, 1, 3), std::numbers::pi);          // touching from inside
  EXPECT_DOUBLE_EQ(disc_circle_area(0.1, 1, 0.5), std::numbers::pi / 4);  // circle within the disc
  EXPECT_DOUBLE_EQ(disc_circle_area(0, 1, 1), std::numbers::pi);          // the same
  EXPECT_EQ(disc_circle_area(0.3, 1, 0), 0);                              // circle of no size
}

TEST(DiscCircleArea, EqualRadiiAsWorkedByHand) {
  // a = R = d = 1: both half-angles are 60 degrees, so A = 2 (pi/3 - sqrt(3)/4). Rounding only: 4 units in
  // the last place.
  EXPECT_DOUBLE_EQ(disc_circle_area(1, 1, 1), 2 * (std::numbers::pi / 3 - std::numbers::sqrt3 / 4));
}

TEST(DiscCircleArea, SegmentSeriesMeetsTheDifferenceWhereTheyChange) {
  // Both forms hold at 2 theta = 1; the difference there has lost one digit, hence 1e-15 of an area of 0.08.
  const double theta = 0.5;
  EXPECT_NEAR(segment_area(theta), theta - std::sin(theta) * std::cos(theta), 1e-16);
  // theta = 1e-5: 2/3 theta^3 (1 - theta^2/5 + ...), of which a plain difference keeps six digits at most.
  EXPECT_NEAR(segment_area(1e-5) / (2e-15 / 3 * (1 - 2e-11)), 1, 1e-15);
}

TEST(DiscCircleArea, RandomCrossingsAgreeWithExtendedPrecision) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 50000; ++i) {
    const double a = 1;
    const double R = std::pow(10.0, 3 * uniform(random) - 1);  // from 0.1 to 100 radii of the disc
    const double d = std::abs(R - a) + uniform(random) * (R + a - std::abs(R - a));
    worst = std::max(worst, error_by_disc_area(d, a, R));
  }
  expect_measured(worst, 0, tolerance);
}

TEST(DiscCircleArea, SliversAgreeWithExtendedPrecision) {
  // Depth of the crossing from 1e-1 down to 1e-15 radii, the disc just outside, just inside, and around the
  // circle.
  double worst = 0;
  for (double depth = 0.1; depth > 1e-15; depth /= 3) {
    for (const double R : {0.2, 0.999, 1.0, 5.0, 28.1}) {
      for (const double d : {R + 1 - depth, std::abs(R - 1) + depth, R, 1.0})
        worst = std::max(worst, error_by_disc_area(d, 1, R));
    }
  }
  expect_measured(worst, 0, tolerance);
}

TEST(DiscRingFraction, ThinRingAgreesWithExtendedPrecision) {
  // Rings of 1/1000 of the disc's radius all across it, for a disc of the shear cell (a = 3.71 mm) at r =
  // 0.15 m.
  const double a = 3.71e-3;
  const double d = 0.15;
  double worst = 0;
  for (int i = -1100; i < 1100; ++i) {
    const double inner = d + a * i / 1000;
    const double outer = d + a * (i + 1) / 1000;
    const Long expected = (lens(d, a, outer) - lens(d, a, inner)) / (pi * a * a);
    worst = std::max(worst, std::abs(static_cast<double>(disc_ring_fraction(d, a, inner, outer) - expected)));
  }
  expect_measured(worst, 0, tolerance);
}

}  // namespace
}  // namespace mikromakro
