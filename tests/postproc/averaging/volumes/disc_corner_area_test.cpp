// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/disc_corner_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "averaging/volumes/reference_areas.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

// Promised for single areas: 1e-13 of the disc's area.
constexpr double tolerance = 1e-13;

double in_rectangle(const Rectangle& r) {
  return disc_quadrant_area(r.right, r.top) - disc_quadrant_area(r.left, r.top) -
         disc_quadrant_area(r.right, r.bottom) + disc_quadrant_area(r.left, r.bottom);
}

// One quarter, one half, and (1/2, 1/2): the quarter's pi/4, two half segments' pi/12 + sqrt(3)/8, the
// square's 1/4.
TEST(DiscQuadrantArea, IsKnownByHand) {
  EXPECT_DOUBLE_EQ(disc_quadrant_area(0, 0), pi / 4);
  EXPECT_DOUBLE_EQ(disc_quadrant_area(0, 5), pi / 2);
  EXPECT_DOUBLE_EQ(disc_quadrant_area(5, 5), pi);
  EXPECT_EQ(disc_quadrant_area(-1, 3), 0);
  EXPECT_EQ(disc_quadrant_area(-0.8, -0.8), 0);
  EXPECT_DOUBLE_EQ(disc_quadrant_area(0.5, 0.5), pi / 4 + 2 * (pi / 12 + std::numbers::sqrt3 / 8) + 0.25);
}

TEST(DiscQuadrantArea, RandomRectanglesAgreeWithQuadrature) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1.3, 1.3);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [left, right] = std::minmax({uniform(random), uniform(random)});
    const auto [bottom, top] = std::minmax({uniform(random), uniform(random)});
    const Rectangle r{left, right, bottom, top};
    worst = std::max(worst, static_cast<double>(std::abs(in_rectangle(r) - rectangle_reference(r))));
  }
  expect_measured(worst / pi, 0, tolerance);
}

// Strips and squares down to 1e-15 wide, at the rim, at corners on the rim, across the centre.
TEST(DiscQuadrantArea, SliversAgreeWithQuadrature) {
  double worst = 0;
  for (double width = 0.1; width > 1e-15; width /= 3) {
    for (const double x : {-1.0, 1 - width, -width / 2, 0.0, std::numbers::sqrt2 / 2}) {
      for (const double y : {-2.0, -1.0, -width / 3, 1 - width, std::numbers::sqrt2 / 2 - width}) {
        for (const double length : {width, 3.0}) {
          const Rectangle r{x, x + width, y, y + length};
          worst = std::max(worst, static_cast<double>(std::abs(in_rectangle(r) - rectangle_reference(r))));
        }
      }
    }
  }
  expect_measured(worst / pi, 0, tolerance);
}

double in_sector(const Sector& sector) {
  const struct {
    double d, inner, outer, begin, end;
  } s{static_cast<double>(sector.d), static_cast<double>(sector.inner), static_cast<double>(sector.outer),
      static_cast<double>(sector.begin), static_cast<double>(sector.end)};
  return sector_corner(s.d, 1, s.outer, s.end) - sector_corner(s.d, 1, s.outer, s.begin) -
         sector_corner(s.d, 1, s.inner, s.end) + sector_corner(s.d, 1, s.inner, s.begin);
}

double sector_error(const Sector& s) {
  return static_cast<double>(std::abs(in_sector(s) - sector_reference(s)) / std::numbers::pi_v<Long>);
}

// Quarter of a disc around the centre; half of it on one side of a line through its centre far away.
TEST(SectorCorner, IsKnownByHand) {
  EXPECT_DOUBLE_EQ(in_sector({0, 0, 3, 0, pi / 2}), pi / 4);
  EXPECT_DOUBLE_EQ(in_sector({0, 0.5, 1, -1, 1}), 0.75);
  EXPECT_DOUBLE_EQ(in_sector({5, 0, 10, 0, pi}), pi / 2);
  EXPECT_DOUBLE_EQ(in_sector({5, 0, 10, -1, 1}), pi);
  EXPECT_DOUBLE_EQ(in_sector({5, 0, 10, 1 - 2 * pi, -1}) + 1, 1);
}

TEST(SectorCorner, RandomSectorsAgreeWithQuadrature) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    // From discs around the centre to discs 100 radii away.
    const double d = i % 3 == 0 ? 1.5 * uniform(random) : std::pow(10.0, 2 * uniform(random));
    const double inner = std::max(0.0, d - 1.2 + 2.2 * uniform(random));
    const double outer = inner + 2 * uniform(random);
    const double reach = d > 1 ? 1.3 * std::asin(1 / d) : pi;
    const double begin = reach * (2 * uniform(random) - 1);
    const double end = begin + (i % 2 == 0 ? reach : 2 * pi) * uniform(random);
    worst = std::max(worst, sector_error({d, inner, outer, begin, end}));
  }
  expect_measured(worst, 0, tolerance);
}

// Thin rings, narrow sectors, both, at the disc's centre, its rim, and around the origin.
TEST(SectorCorner, SliversAgreeWithQuadrature) {
  double worst = 0;
  for (double width = 0.1; width > 1e-15; width /= 3) {
    for (const double d : {0.0, 0.3, 0.999999, 1.0, 1.000001, 2.0, 40.0}) {
      for (const double inner : {0.0, std::max(0.0, d - 1), std::abs(d - 1) + width, d, d + 1 - width}) {
        for (const double begin : {0.0, -width / 2, 1 / (d + 1), -pi}) {
          worst = std::max(worst, sector_error({d, inner, inner + width, begin, begin + width}));
          worst = std::max(worst, sector_error({d, inner, inner + 3, begin, begin + width}));
          worst = std::max(worst, sector_error({d, inner, inner + width, begin, begin + 2}));
        }
      }
    }
  }
  expect_measured(worst, 0, tolerance);
}

}  // namespace
}  // namespace mikromakro
