// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of points and branches with kernels, in all kinds of volumes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>

#include "averaging/kernels/kernel_references.h"
#include "averaging/kernels/kernel_weight.h"
#include "averaging/volumes/grid_volumes.h"
#include "averaging/volumes/ring_volumes.h"
#include "averaging/volumes/sector_volumes.h"
#include "measured_error.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

std::map<int, double> by_volume(const ShareSums& sums) {
  std::map<int, double> shares;
  for (const Share& share : sums.list()) {
    EXPECT_EQ(shares.count(share.volume), 0U);
    shares[share.volume] = share.weight;
  }
  return shares;
}

std::map<int, double> shares_of_point(const Volumes& volumes, const std::string& weight,
                                      const Eigen::Vector2d& point) {
  ShareSums sums;
  make_weight(weight)->in(volumes)->of_point(point, sums);
  return by_volume(sums);
}

double sum_of(const std::map<int, double>& shares) {
  double sum = 0;
  for (const auto& [volume, share] : shares) sum += share;
  return sum;
}

std::unique_ptr<const RingVolumes> rings_at(const Eigen::Vector2d& centre, std::vector<double> edges) {
  return std::make_unique<const RingVolumes>(centre, std::move(edges), 1);
}

// All kinds of volumes around (2, -1) so far that nothing of a kernel at a point near it lies outside.
std::vector<std::unique_ptr<const Volumes>> wide_volumes() {
  const Eigen::Vector2d centre{2, -1};
  std::vector<std::unique_ptr<const Volumes>> all;
  all.push_back(rings_at(centre, {0, 0.1, 1, 3, 3.5, 7, 40}));
  for (const int sectors : {1, 2, 7})
    all.push_back(std::make_unique<const SectorVolumes>(rings_at(centre, {0, 0.4, 2, 3, 40}), sectors));
  all.push_back(std::make_unique<const GridVolumes>(std::vector<double>{-40, 1, 1.7, 2, 3, 40},
                                                    equal_grid_edges(-30, 30, 41, "--grid"), 1));
  return all;
}

const std::vector<std::string> weights = {"gauss:0.8", "lucy:1.9", "wendland:2.1", "tophat:1.3"};

// Promised: 1e-10. Rings and rectangles telescope to 1; sectors add up quadratures.
TEST(KernelShares, SumToOneOverVolumesThatHoldTheKernel) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-4, 4);
  const auto all = wide_volumes();
  for (const std::string& weight : weights) {
    for (const auto& volumes : all) {
      for (int i = 0; i < 20; ++i) {
        const Eigen::Vector2d point{2 + uniform(random), -1 + uniform(random)};
        expect_measured(sum_of(shares_of_point(*volumes, weight, point)), 1, 1e-10, weight);
      }
      expect_measured(sum_of(shares_of_point(*volumes, weight, {2, -1})), 1, 1e-10, weight);
    }
  }
}

// Kernel of width 0.5 at distances 0 to 10; every fifth ring of 0.2.
TEST(KernelShares, InRingsAreTheIntegralsOfTheKernel) {
  const double width = 0.5;
  const RingVolumes rings({0, 0}, equal_ring_edges(0, 12, 60), 1);
  for (const NamedKernel& kernel : kernels()) {
    const auto points = rings.point_shares(kernel.make(width));
    for (const double distance : {0.0, 0.03, 0.26, 0.5, 1.0, 3.81, 10.0}) {
      ShareSums sums;
      points->add({0, distance}, 1, sums);
      auto shares = by_volume(sums);
      for (int ring = 0; ring < 60; ring += 5) {
        const KernelSector sector{distance / width, 0.2 * ring / width, 0.2 * (ring + 1) / width, -pi, pi};
        expect_measured(shares[ring], sector_part(kernel.name, sector), 1e-10, kernel.name);
      }
    }
  }
}

TEST(KernelShares, InSectorsAreTheIntegralsOfTheKernel) {
  const double width = 0.5;
  const SectorVolumes sectors(rings_at({0, 0}, {0, 0.6, 1, 2.2, 6}), 5);
  for (const NamedKernel& kernel : kernels()) {
    const auto points = sectors.point_shares(kernel.make(width));
    for (const double distance : {0.0, 0.2, 0.9, 2.0, 3.0}) {
      // The direction of the centre of sector 0 plus a little: shares in sector 0 and its neighbour 1.
      const double direction = 0.3;
      ShareSums sums;
      points->add(distance * Eigen::Vector2d(std::cos(direction), std::sin(direction)), 1, sums);
      auto shares = by_volume(sums);
      const std::vector<double> edges = {0, 0.6, 1, 2.2, 6};
      for (std::size_t ring = 0; ring < 4; ++ring) {
        for (const int sector : {0, 1}) {
          const KernelSector reference{distance / width, edges[ring] / width, edges[ring + 1] / width,
                                       2 * pi / 5 * sector - direction,
                                       2 * pi / 5 * (sector + 1) - direction};
          expect_measured(shares[static_cast<int>(ring) * 5 + sector], sector_part(kernel.name, reference),
                          1e-10, kernel.name);
        }
      }
    }
  }
}

// On the line where two sectors meet either has half of the kernel, also where the direction of the line is 0
// or pi.
TEST(KernelShares, OnTheLineBetweenTwoSectorsAreHalves) {
  const SectorVolumes sectors(rings_at({0, 0}, {0.3, 0.7}), 4);
  const std::pair<Eigen::Vector2d, int> places[] = {{{0.5, 0}, 0},  {{0.5, -0.0}, 0},  {{0, 0.5}, 1},
                                                    {{-0.5, 0}, 2}, {{-0.5, -0.0}, 2}, {{0, -0.5}, 3}};
  for (const std::string weight : {"gauss:0.02", "lucy:0.2", "wendland:0.2", "tophat:0.2"}) {
    for (const auto& [place, sector] : places) {
      auto shares = shares_of_point(sectors, weight, place);
      expect_measured(shares[sector], 0.5, 1e-10, weight);
      expect_measured(shares[(sector + 3) % 4], 0.5, 1e-10, weight);
    }
  }
}

TEST(KernelShares, InRectanglesAreTheIntegralsOfTheKernel) {
  const double width = 0.5;
  const std::vector<double> x = {-1.5, -0.4, 0.02, 0.3, 2};
  const std::vector<double> y = {-0.7, -0.2, 0.2, 1};
  const GridVolumes grid(x, y, 1);
  const Eigen::Vector2d point{0.1, -0.05};
  for (const NamedKernel& kernel : kernels()) {
    ShareSums sums;
    grid.point_shares(kernel.make(width))->add(point, 1, sums);
    auto shares = by_volume(sums);
    for (int cell = 0; cell < grid.count(); ++cell) {
      const auto i = static_cast<std::size_t>(cell % 4);
      const auto j = static_cast<std::size_t>(cell / 4);
      const KernelRectangle reference{(x[i] - point[0]) / width, (x[i + 1] - point[0]) / width,
                                      (y[j] - point[1]) / width, (y[j + 1] - point[1]) / width};
      expect_measured(shares[cell], rectangle_part(kernel.name, reference), 1e-11, kernel.name);
    }
  }
}

TEST(KernelShares, OfATopHatAreAreasOfItsDisc) {
  for (const auto& volumes : wide_volumes()) {
    const Eigen::Vector2d point{3.1, -0.2};
    std::vector<Share> slices;
    volumes->slice(point, 1.3, slices);
    auto shares = shares_of_point(*volumes, "tophat:1.3", point);
    EXPECT_EQ(shares.size(), slices.size());
    for (const Share& slice : slices) EXPECT_EQ(shares[slice.volume], slice.weight);
  }
}

// The mean over the branch by 4000 midpoints (error 1e-7 of their second derivative at most 1: below 1e-8)
// against the quadrature: as promised, 1e-8 for smooth kernels, 1e-4 for the top-hat.
TEST(KernelShares, OfABranchAreMeansOfThoseOfItsPoints) {
  const Eigen::Vector2d from{2.9, -0.4};
  const Eigen::Vector2d branch{0.5, 0.83};
  constexpr int count = 4000;
  for (const std::string& weight : weights) {
    const double tolerance = weight.starts_with("tophat") ? 1e-4 : 1e-8;
    for (const auto& volumes : wide_volumes()) {
      const auto made = make_weight(weight)->in(*volumes);
      ShareSums sums;
      for (int i = 0; i < count; ++i) {
        ShareSums point;
        made->of_point(from + (i + 0.5) / count * branch, point);
        for (const Share& share : point.list()) sums.add(share.volume, share.weight / count);
      }
      ShareSums quadrature;
      made->of_branch(from, branch, quadrature);
      auto shares = by_volume(quadrature);
      for (const auto& [volume, share] : by_volume(sums))
        expect_measured(shares[volume], share, tolerance, weight);
    }
  }
}

TEST(KernelShares, AddsAreSumsAndAreForgottenAfterClear) {
  ShareSums sums;
  sums.add(70, 0.25);
  sums.add(3, 1);
  sums.add(70, 0.5);
  EXPECT_EQ(by_volume(sums), (std::map<int, double>{{3, 1}, {70, 0.75}}));
  sums.clear();
  sums.add(3, 0.5);
  EXPECT_EQ(by_volume(sums), (std::map<int, double>{{3, 0.5}}));
}

TEST(KernelShares, TooManyRingsAreBadInput) {
  const RingVolumes rings({0, 0}, equal_ring_edges(0, 1, 10001), 1);
  EXPECT_THROW(make_weight("gauss:1")->in(rings), Error);
  EXPECT_NO_THROW(make_weight("tophat:1")->in(rings));
}

}  // namespace
}  // namespace mikromakro
