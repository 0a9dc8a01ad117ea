// SPDX-License-Identifier: GPL-2.0-or-later
// Averages in periodic boxes: the same wherever the box begins, and those of many boxes side by side.
#include <gtest/gtest.h>

#include <numbers>

#include "averaging/volumes/grid_volumes.h"
#include "averaging/volumes/sector_volumes.h"
#include "measured_error.h"
#include "model/error.h"
#include "periodic_packing.h"

namespace mikromakro {
namespace {

using MakeVolumes = std::unique_ptr<const Volumes> (*)();

constexpr double h = 0.5;
const Box periodic{{-1.3, 0.4}, {2.1, 3.2}, {true, true}};
const Box along_x{{-1.3, 0.4}, {2.1, 3.2}, {true, false}};

std::unique_ptr<const Volumes> grid(const Box& part, int columns, int rows) {
  return std::make_unique<const GridVolumes>(equal_grid_edges(part.low.x(), part.high.x(), columns, ""),
                                             equal_grid_edges(part.low.y(), part.high.y(), rows, ""), h);
}
std::unique_ptr<const RingVolumes> rings(const Eigen::Vector2d& centre, const std::vector<double>& edges) {
  return std::make_unique<const RingVolumes>(centre, edges, h);
}

AverageSetup all_fields(const std::string& weight) {
  AverageSetup setup;
  setup.weight = weight;
  setup.options.bulk_types = {1};
  setup.fields = {"all"};
  setup.field_options = {50, 0.3, 12};
  return setup;
}

// By how much a column magnifies rounding: see invariance_test.cpp; the fit has no exponential profile here.
double conditioning(const std::string& name) {
  if (name.ends_with("_fit")) return 1e6;
  return name.find("angle") != name.npos || name == "G" || name == "E" || name.starts_with("mu_c") ? 1000
                                                                                                   : 10;
}

void expect_same(const Table& first, const Table& second, double tolerance) {
  ASSERT_EQ(first.columns.size(), second.columns.size());
  for (Eigen::Index row = 0; row < first.rows.rows(); ++row) {
    for (Eigen::Index column = 0; column < first.rows.cols(); ++column) {
      const double value = first.rows(row, column);
      const double other = second.rows(row, column);
      const std::string& name = first.columns[static_cast<std::size_t>(column)].name;
      if (std::isnan(value) && std::isnan(other)) continue;
      const double size = std::fmax(1.0, std::abs(other)) * conditioning(name);
      expect_measured(value / size, other / size, tolerance, name);
    }
  }
}

class PeriodicAverages : public testing::TestWithParam<std::string> {
 protected:
  void expect_as_copies(const Box& box, const MakeVolumes make) const {
    const Frame frame = periodic_packing(box, 25);
    const AverageSetup setup = all_fields(GetParam());
    expect_same(VolumeAverage(frame, make(), setup).table(),
                VolumeAverage(copied(frame, 4), make(), setup).table(), 1e-12);
  }
};
INSTANTIATE_TEST_SUITE_P(Weights, PeriodicAverages,
                         testing::Values("sliced", "centre", "gauss:0.15", "gauss:1", "lucy:0.8", "lucy:4",
                                         "wendland:0.8", "tophat:0.6", "tophat:5"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == ':' || c == '.'; }, '_');
                           return name;
                         });

// The whole box, wherever the packing lies in it; relative to values above 1, sums of 10^2 terms: 1e-13.
TEST_P(PeriodicAverages, OfTheWholeBoxDoNotChangeWhenThePackingMoves) {
  const Frame frame = periodic_packing(periodic, 25);
  const AverageSetup setup = all_fields(GetParam());
  const Table still = VolumeAverage(frame, grid(periodic, 1, 1), setup).table();
  for (const Eigen::Vector2d& shift : std::vector<Eigen::Vector2d>{
           {0.3, 0}, {0, -0.7}, {1.234, 2.345}, {-3.4, 2.8}, {1e-9, -1e-9}, {1.7, 1.4}}) {
    expect_same(VolumeAverage(moved(frame, shift), grid(periodic, 1, 1), setup).table(), still, 1e-13);
    // Not brought back into the box at all.
    Frame outside = frame;
    for (Particle& particle : outside.particles) particle.position += shift;
    expect_same(VolumeAverage(outside, grid(periodic, 1, 1), setup).table(), still, 1e-13);
  }
}

// Every disc and every contact counts wholly in the whole box: by hand, whatever the weight.
TEST_P(PeriodicAverages, OfTheWholeBoxAreSumsOverAllDiscs) {
  const Frame frame = periodic_packing(periodic, 25);
  AverageSetup setup = all_fields(GetParam());
  setup.options = {{}, Branch::contact};
  const VolumeAverage average(frame, grid(periodic, 1, 1), setup);
  const double area = periodic.length().prod();
  double squares = 0;
  for (const Particle& particle : frame.particles) squares += particle.radius * particle.radius;
  expect_measured(average.at("nu"), std::numbers::pi * squares / area, 1e-13);
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
  for (const Contact& contact : frame.contacts) {
    const double distance = frame.particles[static_cast<std::size_t>(contact.index1)].radius +
                            frame.particles[static_cast<std::size_t>(contact.index2)].radius -
                            contact.overlap;
    stress += contact.force * (distance * contact.normal).transpose() / (area * h);
  }
  const double size = stress.cwiseAbs().maxCoeff();
  expect_measured(average.at("sigma_xx") / size, stress(0, 0) / size, 1e-13);
  expect_measured(average.at("sigma_xy") / size, stress(0, 1) / size, 1e-13);
  expect_measured(average.at("sigma_yx") / size, stress(1, 0) / size, 1e-13);
  expect_measured(average.at("sigma_yy") / size, stress(1, 1) / size, 1e-13);
  expect_measured(average.at("coordination_number_averaged"),
                  2.0 * static_cast<double>(frame.contacts.size()) / 25, 1e-13);
}

// A box of another place and twice the length has the same averages.
TEST_P(PeriodicAverages, OfTwoBoxesAreThoseOfOne) {
  const Frame frame = periodic_packing(periodic, 25);
  const AverageSetup setup = all_fields(GetParam());
  const Eigen::Vector2d shift{0.77, -0.31};
  const Box twice{periodic.low + shift, periodic.high + shift + periodic.length(), {}};
  Table two = VolumeAverage(frame, grid(twice, 1, 1), setup).table();
  const Table one = VolumeAverage(frame, grid(periodic, 1, 1), setup).table();
  two.rows.leftCols(6) = one.rows.leftCols(6);
  expect_same(two, one, 1e-13);
}

TEST_P(PeriodicAverages, OfCellsAddUpToTheWhole) {
  const Frame frame = periodic_packing(periodic, 25);
  AverageSetup setup = all_fields(GetParam());
  setup.fields = {"solid_fraction", "stress", "fabric", "couple_stress", "wall_force_density"};
  const Table whole = VolumeAverage(frame, grid(periodic, 1, 1), setup).table();
  const Table cells = VolumeAverage(frame, grid(periodic, 5, 3), setup).table();
  for (Eigen::Index column = 6; column < whole.rows.cols(); ++column) {
    const double size = std::fmax(1, std::abs(whole.rows(0, column)));
    expect_measured(cells.rows.col(column).mean() / size, whole.rows(0, column) / size, 1e-12,
                    whole.columns[static_cast<std::size_t>(column)].name);
  }
}

TEST_P(PeriodicAverages, OfAGridAreThoseOfBoxesSideBySide) {
  expect_as_copies(periodic, [] { return grid(periodic, 5, 3); });
}
TEST_P(PeriodicAverages, OfAGridLargerThanTheBoxAreThoseOfBoxesSideBySide) {
  expect_as_copies(periodic, [] { return grid({{-3.1, 1}, {2.9, 2.5}, {}}, 4, 2); });
}
TEST_P(PeriodicAverages, OfRingsAroundACornerAreThoseOfBoxesSideBySide) {
  expect_as_copies(periodic, [] {
    return std::unique_ptr<const Volumes>(rings({-1.3, 0.4}, {0, 0.4, 0.9, 1.6}));
  });
}
// A sector on either side of the seam, of rings larger than the box.
TEST_P(PeriodicAverages, OfSectorsAreThoseOfBoxesSideBySide) {
  expect_as_copies(periodic, [] {
    return std::unique_ptr<const Volumes>(
        std::make_unique<const SectorVolumes>(rings({2.1, 1.9}, {0.5, 1.2, 2.4}), 5));
  });
}
TEST_P(PeriodicAverages, AlongOneAxisAreThoseOfBoxesSideBySide) {
  expect_as_copies(along_x, [] { return grid(periodic, 5, 3); });
  expect_as_copies(along_x, [] {
    return std::unique_ptr<const Volumes>(rings({-1.3, 0.4}, {0, 0.4, 0.9, 1.6}));
  });
}

// A box in which a disc touches its own image, left and right: radius 0.55, box 1 by 8, the other disc far
// away. sigma_xx = -2 N * 1 m/(8 m^2), two contacts, nu = (pi 0.55^2 + pi 0.1^2)/8.
TEST(PeriodicAverage, OfADiscThatTouchesItsOwnImage) {
  Frame frame;
  frame.box = {{0, 0}, {1, 8}, {true, true}};
  frame.particles = {make_disc(1, {0.2, 1}, 0.55), make_disc(2, {0.2, 5}, 0.1)};
  Contact contact;
  contact.id1 = contact.id2 = 1;
  contact.index1 = contact.index2 = 0;
  contact.normal = {1, 0};
  contact.overlap = 0.1;
  contact.force = {-2, 0};
  frame.contacts = {contact};
  for (const std::string weight : {"sliced", "centre", "gauss:0.2", "lucy:3"}) {
    AverageSetup setup = all_fields(weight);
    setup.options.branch = Branch::contact;
    const VolumeAverage average(
        frame, std::make_unique<const GridVolumes>(std::vector<double>{0, 1}, std::vector<double>{0, 8}, 1),
        setup);
    expect_measured(average.at("nu"), std::numbers::pi * (0.3025 + 0.01) / 8, 1e-14, weight);
    expect_measured(average.at("sigma_xx"), -0.25, 1e-14, weight);
    expect_measured(average.at("coordination_number_averaged"), 1, 1e-14, weight);
  }
}

// Half of a disc of radius 1 at the boundary x = 0 of a box of 4 m in each of the outer columns.
TEST(PeriodicAverage, OfADiscOnTheBoundaryIsHalfOnEitherSide) {
  Frame frame;
  frame.box = {{0, 0}, {4, 4}, {true, true}};
  for (const double x : {0.0, 4.0, -4.0, 8.0}) {
    frame.particles = {make_disc(1, {x, 2}, 1)};
    AverageSetup setup;
    setup.fields = {"solid_fraction"};
    const VolumeAverage average(frame, grid({{0, 0}, {4, 4}, {}}, 4, 1), setup);
    expect_measured(average.at("nu", 0), std::numbers::pi / 8, 1e-15);
    expect_measured(average.at("nu", 1), 0, 0);
    expect_measured(average.at("nu", 2), 0, 0);
    expect_measured(average.at("nu", 3), std::numbers::pi / 8, 1e-15);
  }
}

// The box of each frame counts: one that grows from 4 to 5 m.
TEST(PeriodicAverage, TakesTheBoxOfEachFrame) {
  AverageSetup setup;
  setup.fields = {"solid_fraction"};
  for (const double side : {4.0, 5.0}) {
    Frame frame;
    frame.box = {{0, 0}, {side, 4}, {true, false}};
    frame.particles = {make_disc(1, {0, 2}, 1)};
    const VolumeAverage average(frame, grid({{3.5, 0}, {4.5, 4}, {}}, 1, 1), setup);
    // 3.5 to 4.5 is half a radius to either side of 4 for the one, all beyond half a radius of 5 for the
    // other.
    const double middle = 2 * (0.5 * std::sqrt(0.75) + std::asin(0.5));
    const double cap = std::numbers::pi / 2 - 0.5 * middle;
    expect_measured(average.at("nu"), (side == 4 ? middle : cap) / 4, 1e-15);
  }
}

TEST(PeriodicAverage, TooManyImagesAreAnError) {
  const Frame frame = periodic_packing(periodic, 3);
  EXPECT_THROW(VolumeAverage(frame, grid(periodic, 1, 1), all_fields("gauss:100")), Error);
}

}  // namespace
}  // namespace mikromakro
