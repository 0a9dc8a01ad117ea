#include "averaging/disc_circle_area.h"

#include <gtest/gtest.h>
#include <quadmath.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measured_error.h"

namespace mikromakro {
namespace {

__extension__ using Quad = __float128;
const Quad quad_pi = acosq(-1);

// Reference: the textbook lens formula in quadruple precision (33 digits). It loses up to 17 of them in a
// sliver (acos near 1), so it is still exact to 1e-16 of the disc's area, and it shares no formula with the
// code under test.
Quad lens(Quad d, Quad a, Quad R) {
  if (d >= a + R) return 0;
  if (d + a <= R) return quad_pi * a * a;
  if (d + R <= a) return quad_pi * R * R;
  const Quad alpha = acosq((d * d + a * a - R * R) / (2 * d * a));
  const Quad beta = acosq((d * d + R * R - a * a) / (2 * d * R));
  return a * a * (alpha - sinq(alpha) * cosq(alpha)) + R * R * (beta - sinq(beta) * cosq(beta));
}

double error_by_disc_area(double d, double a, double R) {
  const Quad difference = disc_circle_area(d, a, R) - lens(d, a, R);
  return static_cast<double>(fabsq(difference) / (quad_pi * Quad(a) * Quad(a)));
}

// What the task asks for: single areas to 1e-13 of the disc's area.
constexpr double tolerance = 1e-13;

TEST(DiscCircleArea, KnowsTheCasesWithoutCrossing) {
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(disc_circle_area(5, 1, 3), 0);                     // apart
  EXPECT_EQ(disc_circle_area(4, 1, 3), 0);                     // touching from outside
  EXPECT_DOUBLE_EQ(disc_circle_area(1, 1, 3), pi);             // disc within the circle
  EXPECT_DOUBLE_EQ(disc_circle_area(2, 1, 3), pi);             // touching from inside
  EXPECT_DOUBLE_EQ(disc_circle_area(0.1, 1, 0.5), pi * 0.25);  // circle within the disc
  EXPECT_DOUBLE_EQ(disc_circle_area(0, 1, 1), pi);             // the same
  EXPECT_EQ(disc_circle_area(0.3, 1, 0), 0);                   // circle of no size
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

TEST(DiscCircleArea, RandomCrossingsAgreeWithQuadruplePrecision) {
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

TEST(DiscCircleArea, SliversAgreeWithQuadruplePrecision) {
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

TEST(DiscRingFraction, ThinRingAgreesWithQuadruplePrecision) {
  // Rings of 1/1000 of the disc's radius all across it, for a disc of the shear cell (a = 3.71 mm) at r =
  // 0.15 m.
  const double a = 3.71e-3;
  const double d = 0.15;
  double worst = 0;
  for (int i = -1100; i < 1100; ++i) {
    const double inner = d + a * i / 1000;
    const double outer = d + a * (i + 1) / 1000;
    const Quad expected = (lens(d, a, outer) - lens(d, a, inner)) / (quad_pi * Quad(a) * Quad(a));
    worst = std::max(worst, std::abs(static_cast<double>(disc_ring_fraction(d, a, inner, outer) - expected)));
  }
  expect_measured(worst, 0, tolerance);
}

}  // namespace
}  // namespace mikromakro
