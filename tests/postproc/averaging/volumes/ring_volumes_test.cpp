// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/ring_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "averaging/weight.h"
#include "measured_error.h"
#include "model/error.h"

namespace mikromakro {
namespace {

const Eigen::Vector2d origin = Eigen::Vector2d::Zero();

double sum_of_shares(const Volumes& rings, const Eigen::Vector2d& centre, double radius) {
  ShareSums shares;
  SlicedWeight().in(rings)->of_disc(centre, radius, shares);
  double sum = 0;
  for (const Share& share : shares.list()) sum += share.weight;
  return sum;
}

// The fractions telescope: each is a difference of two areas with an error of one rounding of the disc's
// area.
constexpr double tolerance = 1e-13;

TEST(RingVolumes, FractionsOfADiscOverAllRingsSumToOne) {
  const RingVolumes rings(origin, equal_ring_edges(0, 10, 20), 1);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double radius = 0.01 + 3 * uniform(random);
    const double angle = 2 * std::numbers::pi * uniform(random);
    const double distance =
        (10 - radius) * uniform(random);  // some contain the centre of the rings, none leaves them
    worst = std::max(
        worst,
        std::abs(sum_of_shares(rings, {distance * std::cos(angle), distance * std::sin(angle)}, radius) - 1));
  }
  expect_measured(worst, 0, tolerance);
}

TEST(RingVolumes, FractionsSumToOneForRingsMuchThinnerThanTheDisc) {
  const RingVolumes rings(origin, equal_ring_edges(0, 10, 5000), 1);  // 1/500 of the radius
  expect_measured(sum_of_shares(rings, {3, 4}, 1), 1, tolerance);
  expect_measured(sum_of_shares(rings, {0.3, 0.4}, 1), 1, tolerance);  // contains the centre
  expect_measured(sum_of_shares(rings, {0, 0}, 1), 1, tolerance);
}

TEST(RingVolumes, DiscAcrossOneEdgeIsSharedAsWorkedByHand) {
  // A disc of radius 1 around the centre itself, edges 0, 1/2, 1: shares 1/4 and 3/4.
  const RingVolumes rings(origin, {0, 0.5, 1}, 1);
  std::vector<Share> shares;
  rings.slice(origin, 1, shares);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_DOUBLE_EQ(shares[0].weight, 0.25);
  EXPECT_DOUBLE_EQ(shares[1].weight, 0.75);
  EXPECT_EQ(shares[1].volume, 1);
}

TEST(RingVolumes, DiscHalfOutsideCountsWithItsInnerPartOnly) {
  // R = d = a = 1: the lens of two unit circles, (2/3 - sqrt(3)/(2 pi)) of the disc.
  const RingVolumes rings(origin, {0, 1}, 1);
  expect_measured(sum_of_shares(rings, {0, 1}, 1), 2.0 / 3 - std::numbers::sqrt3 / (2 * std::numbers::pi),
                  1e-15);
  EXPECT_EQ(sum_of_shares(rings, {0, 2.5}, 1), 0);
  const RingVolumes outer(origin, {3, 4}, 1);
  EXPECT_EQ(sum_of_shares(outer, {0, 1}, 1), 0);
}

TEST(RingVolumes, CentreWeightTakesTheRingThatHoldsTheCentre) {
  const RingVolumes rings({1, 1}, {1, 2, 3}, 1);
  EXPECT_EQ(rings.find({1.5, 1}), -1);  // r = 0.5
  EXPECT_EQ(rings.find({2, 1}), 0);     // r = 1, the inner edge belongs to the ring
  EXPECT_EQ(rings.find({1, 3}), 1);     // r = 2, on the edge: the outer one
  EXPECT_EQ(rings.find({1, 4}), -1);    // r = 3
}

TEST(RingVolumes, MeasureIsAreaTimesHeight) {
  // pi (2^2 - 1^2) 0.5 and pi (3^2 - 2^2) 0.5
  const RingVolumes rings(origin, {1, 2, 3}, 0.5);
  EXPECT_DOUBLE_EQ(rings.measure()[0], 1.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(rings.measure()[1], 2.5 * std::numbers::pi);
}

TEST(RingVolumes, BadRingsAreRefused) {
  EXPECT_THROW(RingVolumes(origin, {1}, 1), Error);
  EXPECT_THROW(RingVolumes(origin, {-1, 1}, 1), Error);
  EXPECT_THROW(RingVolumes(origin, {1, 1}, 1), Error);
  EXPECT_THROW(RingVolumes(origin, {1, 2}, 0), Error);
  EXPECT_THROW(equal_ring_edges(2, 1, 3), Error);
  EXPECT_THROW(equal_ring_edges(1, 2, 0), Error);
}

}  // namespace
}  // namespace mikromakro
