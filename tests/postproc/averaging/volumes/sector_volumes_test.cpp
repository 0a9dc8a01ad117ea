// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/sector_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "averaging/volumes/reference_areas.h"
#include "lattice_frame.h"
#include "measured_error.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;
const Eigen::Vector2d origin = Eigen::Vector2d::Zero();

SectorVolumes sectors_of(const std::vector<double>& edges, int sectors,
                         const Eigen::Vector2d& centre = origin) {
  return {std::make_unique<const RingVolumes>(centre, edges, 1), sectors};
}

std::vector<Share> shares_of(const Volumes& volumes, const Eigen::Vector2d& centre, double radius) {
  ShareSums shares;
  SlicedWeight().in(volumes)->of_disc(centre, radius, shares);
  return shares.list();
}

double sum_of_shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius) {
  double sum = 0;
  std::set<int> seen;
  for (const Share& share : shares_of(volumes, centre, radius)) {
    EXPECT_TRUE(seen.insert(share.volume).second) << share.volume;
    sum += share.weight;
  }
  return sum;
}

// Differences of areas at corners telescope: some 10^2 cells of 1e-16 each.
TEST(SectorVolumes, FractionsOfADiscOverAllSectorsSumToOne) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (const int count : {1, 2, 3, 7, 64}) {
    const SectorVolumes sectors = sectors_of(equal_ring_edges(0, 10, 12), count, {0.5, -0.25});
    for (int i = 0; i < 5000; ++i) {
      const double radius = 0.01 + 3 * uniform(random);
      const double angle = 2 * pi * uniform(random);
      const double distance = (10 - radius) * uniform(random);  // many contain the centre
      const Eigen::Vector2d place(0.5 + distance * std::cos(angle), -0.25 + distance * std::sin(angle));
      worst = std::max(worst, std::abs(sum_of_shares(sectors, place, radius) - 1));
    }
  }
  expect_measured(worst, 0, 1e-13);
}

// On the centre, through it, on an edge between sectors, on the border of 0 and 360 degrees, and far narrower
// sectors than the disc.
TEST(SectorVolumes, FractionsSumToOneInSpecialPlaces) {
  for (const int count : {1, 4, 1000}) {
    const SectorVolumes sectors = sectors_of(equal_ring_edges(0, 10, 7), count);
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(0, 0), {1, 0}, {0, -1}, {3, 0}, {-3, 0}, {0, 5}})
      expect_measured(sum_of_shares(sectors, place, 1), 1, 1e-13);
  }
}

// Discs of the shear cell (a = 3.71 mm at r = 0.15 m) in sectors of half a degree. A rounding of the angles
// (2 pi 1e-16) moves the straight sides by 40 times as much in radii of the disc: 1e-13 leaves a factor of 4.
TEST(SectorVolumes, SharesInTheShearCellAgreeWithQuadrature) {
  const std::vector<double> edges = {0.148, 0.1495, 0.151};
  const SectorVolumes sectors = sectors_of(edges, 720);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300; ++i) {
    const double phi = 2 * pi * uniform(random);
    const Eigen::Vector2d centre =
        (0.15 + 0.004 * (uniform(random) - 0.5)) * Eigen::Vector2d(std::cos(phi), std::sin(phi));
    const Long a = double{3.71e-3};
    const Long direction = std::atan2(Long{centre[1]}, Long{centre[0]});
    for (const Share& share : shares_of(sectors, centre, 3.71e-3)) {
      const auto ring = static_cast<std::size_t>(share.volume / 720);
      const Long width = 2 * std::numbers::pi_v<Long> / 720;
      const Long begin = std::remainder(share.volume % 720 * width - direction, 720 * width);
      const Sector sector{std::hypot(Long{centre[0]}, Long{centre[1]}) / a, edges[ring] / a,
                          edges[ring + 1] / a, begin, begin + width};
      expect_measured(share.weight, static_cast<double>(sector_reference(sector) / std::numbers::pi_v<Long>),
                      1e-13);
    }
  }
}

// Fractions of one disc in each ring, summed over its sectors, are those of RingVolumes.
TEST(SectorVolumes, SectorsOfARingAddUpToTheRing) {
  const std::vector<double> edges = {0.5, 1, 1.7, 4};
  const RingVolumes rings(origin, edges, 1);
  const SectorVolumes sectors = sectors_of(edges, 5);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d place{uniform(random), uniform(random)};
    const double radius = 0.1 + std::abs(uniform(random));
    double of_ring[3] = {};
    for (const Share& share : shares_of(sectors, place, radius)) of_ring[share.volume / 5] += share.weight;
    for (const Share& share : shares_of(rings, place, radius)) of_ring[share.volume] -= share.weight;
    for (const double difference : of_ring) expect_measured(difference, 0, 1e-13);
  }
}

// A disc of radius 1 at the centre, edges 0, 1/2, 1, four sectors: 1/16 and 3/16 each.
TEST(SectorVolumes, DiscAroundTheCentreIsSharedAsWorkedByHand) {
  const auto shares = shares_of(sectors_of({0, 0.5, 1}, 4), origin, 1);
  ASSERT_EQ(shares.size(), 8U);
  for (const Share& share : shares) EXPECT_DOUBLE_EQ(share.weight, share.volume < 4 ? 1.0 / 16 : 3.0 / 16);
}

// Halved by the line at 0 degrees: the first sector and the last one.
TEST(SectorVolumes, DiscAcrossZeroDegreesIsHalved) {
  const auto shares = shares_of(sectors_of({0, 10}, 6), {5, 0}, 1);
  ASSERT_EQ(shares.size(), 2U);
  for (const Share& share : shares) {
    EXPECT_TRUE(share.volume == 0 || share.volume == 5);
    EXPECT_DOUBLE_EQ(share.weight, 0.5);
  }
}

TEST(SectorVolumes, VolumesThatTheDiscDoesNotTouchHaveNoShare) {
  const SectorVolumes sectors = sectors_of({1, 4, 10, 20}, 360);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    // Within the 41st sector, 1 degree wide, and the third ring.
    const double phi = (40.5 + 0.3 * uniform(random)) * pi / 180;
    const double r = 15 + 4.9 * uniform(random);
    const auto shares = shares_of(sectors, {r * std::cos(phi), r * std::sin(phi)}, 0.03);
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares[0].volume, 2 * 360 + 40);
  }
}

TEST(SectorVolumes, CentreWeightTakesTheSectorThatHoldsTheCentre) {
  const SectorVolumes sectors = sectors_of({1, 2, 3}, 4, {1, 1});
  EXPECT_EQ(sectors.find({1, 1.5}), -1);
  EXPECT_EQ(sectors.find({2.5, 1}), 0);  // 0 degrees: where a sector begins belongs to it
  EXPECT_EQ(sectors.find({1, 2.5}), 1);
  EXPECT_EQ(sectors.find({-0.5, 1}), 2);
  EXPECT_EQ(sectors.find({1, -1.5}), 7);
  EXPECT_EQ(sectors.find({3.1, 0.99}), 7);
}

TEST(SectorVolumes, MeasureAndCoordinates) {
  const SectorVolumes sectors = sectors_of({1, 2, 3}, 4);
  EXPECT_DOUBLE_EQ(sectors.measure()[3], 3 * pi / 4);
  EXPECT_DOUBLE_EQ(sectors.measure()[4], 5 * pi / 4);
  const double last[] = {2, 3, 2.5, 270, 360, 315};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(sectors.coordinates()(7, i), last[i]);
  EXPECT_EQ(sectors.columns()[3].name, "phi_begin");
  EXPECT_THROW(sectors_of({1, 2}, 0), Error);
}

// All fields that are divided by V: each ring is the mean of its (equal) sectors. 1e-12: 10^2 discs.
TEST(SectorAverage, RingsAreTheMeanOfTheirSectors) {
  LatticeSetup lattice{1, 1.96, 50, 4, Eigen::Matrix2d::Identity()};
  lattice.gradient << 1, 0.02, 0.005, 1.001;
  const Frame frame = make_lattice(lattice);
  const std::vector<double> edges = {0, 1.5, 4, 9};
  const RingAverage rings(frame, {edges, {0.3, 0.1}, 1, "sliced", {{1}, Branch::radius}});
  AverageSetup setup;
  setup.options.bulk_types = {1};
  setup.field_options.rings = false;
  const VolumeAverage sectors(
      frame,
      std::make_unique<const SectorVolumes>(
          std::make_unique<const RingVolumes>(Eigen::Vector2d(0.3, 0.1), edges, 1), 9),
      setup);
  for (const std::string name : {"nu", "nu_3", "F_rr", "F_rphi", "F_phiphi", "sigma_rr", "sigma_phir"}) {
    for (int ring = 0; ring < 3; ++ring) {
      double sum = 0;
      for (int i = 0; i < 9; ++i) sum += sectors.at(name, 9 * ring + i) / 9;
      expect_measured(sum, rings.at(name, ring), 1e-12, name);
    }
  }
}

}  // namespace
}  // namespace mikromakro
