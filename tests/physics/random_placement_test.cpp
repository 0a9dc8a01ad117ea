// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/placement/random_placement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro::physics {
namespace {

double smallest_gap(const std::vector<PlacedDisc>& discs) {
  double smallest = 1e300;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = std::hypot(discs[i].x - discs[j].x, discs[i].y - discs[j].y);
      smallest = std::min(smallest, distance - discs[i].radius - discs[j].radius);
    }
  }
  return smallest;
}

// 200 large and 300 small discs: solid fraction (200 * 0.02^2 + 300 * 0.01^2)/(1 - 0.3^2) = 0.12.
std::vector<double> two_sizes() {
  std::vector<double> radii(300, 0.01);
  radii.insert(radii.end(), 200, 0.02);
  return radii;
}

// The standard (rand.predef) gives the 10000th number of a default-seeded mt19937_64: 9981545732273789042.
TEST(UniformNumbers, AreTheUpperBitsOfTheStandardsTwister) {
  UniformNumbers uniform(std::mt19937_64::default_seed);
  for (int i = 1; i < 10000; ++i) uniform(0.0, 1.0);
  EXPECT_EQ(uniform(0.0, 1.0), static_cast<double>(9981545732273789042U >> 11) / 9007199254740992.0);
}

TEST(PlaceDiscs, WithoutOverlapsInsideARing) {
  const Annulus ring{0.5, -0.2, 0.3, 1.0};
  UniformNumbers uniform(1);
  const auto radii = two_sizes();
  const auto discs = place_discs(ring, radii, 0.005, {}, uniform);
  ASSERT_EQ(discs.size(), radii.size());
  // The grid compares squares, the test distances: they differ by rounding of lengths of order 1.
  EXPECT_GE(smallest_gap(discs), -1e-15);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    EXPECT_EQ(discs[i].radius, radii[i]);
    const double r = std::hypot(discs[i].x - 0.5, discs[i].y + 0.2);
    EXPECT_GE(r - discs[i].radius, 0.305 - 1e-15);
    EXPECT_LE(r + discs[i].radius, 0.995 + 1e-15);
  }
}

// Dense enough (0.42) that a neighbour cell that is forgotten shows up.
TEST(PlaceDiscs, WithoutOverlapsInsideARectangle) {
  const Rectangle box{-1.0, 1.0, 0.0, 0.5};
  UniformNumbers uniform(2);
  const auto discs = place_discs(box, std::vector<double>(330, 0.02), 0.0, {}, uniform);
  EXPECT_GE(smallest_gap(discs), -1e-15);
  for (const auto& disc : discs) {
    EXPECT_GE(disc.x, -0.98 - 1e-15);
    EXPECT_LE(disc.x, 0.98 + 1e-15);
    EXPECT_GE(disc.y, 0.02 - 1e-15);
    EXPECT_LE(disc.y, 0.48 + 1e-15);
  }
}

TEST(PlaceDiscs, ClearOfObstaclesEvenOutsideOfTheRegion) {
  const Rectangle box{0.0, 1.0, 0.0, 1.0};
  std::vector<PlacedDisc> all = {{0.5, 0.5, 0.3}, {-0.1, 0.5, 0.2}};
  UniformNumbers uniform(3);
  for (const auto& disc : place_discs(box, std::vector<double>(200, 0.02), 0.0, all, uniform))
    all.push_back(disc);
  EXPECT_GE(smallest_gap({all.begin() + 1, all.end()}), -1e-15);
  EXPECT_GE(smallest_gap({all.begin(), all.begin() + 1}), -1e-15);
  for (std::size_t i = 2; i < all.size(); ++i)
    EXPECT_GE(std::hypot(all[i].x - 0.5, all[i].y - 0.5), 0.32 - 1e-15);
}

TEST(PlaceDiscs, IsDeterministicFromTheSeed) {
  const Annulus ring{0.0, 0.0, 0.3, 1.0};
  UniformNumbers first(7), second(7), other(8);
  const auto a = place_discs(ring, two_sizes(), 0.0, {}, first);
  const auto b = place_discs(ring, two_sizes(), 0.0, {}, second);
  const auto c = place_discs(ring, two_sizes(), 0.0, {}, other);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].x, b[i].x);
    EXPECT_EQ(a[i].y, b[i].y);
  }
  EXPECT_NE(a[0].x, c[0].x);
}

// One disc of radius 0.3 in the middle of a square of side 1 leaves no place for a second of radius 0.25: the
// farthest possible centre is (0.25, 0.25) from the corner, 0.354 from the middle, where 0.55 is needed.
TEST(PlaceDiscs, SaysWhenThereIsNoPlace) {
  UniformNumbers uniform(1);
  EXPECT_THROW(place_discs(Rectangle{0.0, 1.0, 0.0, 1.0}, {0.25}, 0.0, {{0.5, 0.5, 0.3}}, uniform),
               std::runtime_error);
}

// Uniform in a disc of radius V: <v^2> = V^2/2; its standard error with n values is V^2/sqrt(12 n) (v^2 is
// uniform in [0, V^2]); four of them allowed, the seed is fixed.
TEST(RandomVelocity, IsUniformInADisc) {
  UniformNumbers uniform(4);
  const int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const PlaneVector v = random_velocity(0.05, uniform);
    const double square = v.x * v.x + v.y * v.y;
    EXPECT_LE(square, 0.05 * 0.05);
    sum += square;
  }
  EXPECT_NEAR(sum / n, 0.5 * 0.05 * 0.05, 4.0 * 0.05 * 0.05 / std::sqrt(12.0 * n));
}

}  // namespace
}  // namespace mikromakro::physics
