// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/grid_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "lattice_frame.h"
#include "measured_error.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12;  // 10^2 terms of size 1

std::vector<Share> shares_of(const Volumes& volumes, const Eigen::Vector2d& centre, double radius) {
  ShareSums shares;
  SlicedWeight().in(volumes)->of_disc(centre, radius, shares);
  return shares.list();
}

double sum_of_shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius) {
  long double sum = 0;  // the sum's own rounding is not what is tested
  for (const Share& share : shares_of(volumes, centre, radius)) sum += share.weight;
  return static_cast<double>(sum);
}

// Differences of areas at corners telescope: some 10^2 cells of 1e-16 each.
TEST(GridVolumes, FractionsOfADiscOverAllCellsSumToOne) {
  const GridVolumes grid(equal_grid_edges(-10, 10, 15, "--grid"), equal_grid_edges(-10, 10, 40, "--grid"), 1);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double radius = 0.02 + 3 * std::abs(uniform(random));
    const Eigen::Vector2d centre = (10 - radius) * Eigen::Vector2d(uniform(random), uniform(random));
    worst = std::max(worst, std::abs(sum_of_shares(grid, centre, radius) - 1));
  }
  expect_measured(worst, 0, 1e-13);
}

// Centre of the disc on a corner, on an edge, and cells of 1/200 of its radius.
TEST(GridVolumes, FractionsSumToOneOnCornersAndForSmallCells) {
  const GridVolumes grid(equal_grid_edges(-2, 2, 800, "--grid"), equal_grid_edges(-2, 2, 800, "--grid"), 1);
  // 10^5 cells: corners telescope, and each of the shares of 1e-5 has a rounding of 1e-16 to either side.
  for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0, 0), {0.5, 0.1234}, {0.3, 0.77}})
    expect_measured(sum_of_shares(grid, centre, 1), 1, 1e-13);
}

TEST(GridVolumes, DiscOnACornerIsQuartered) {
  const GridVolumes grid({-2, 1, 4}, {0, 2, 4}, 1);
  const auto shares = shares_of(grid, {1, 2}, 1);
  ASSERT_EQ(shares.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(shares[static_cast<std::size_t>(i)].volume, i);
    EXPECT_DOUBLE_EQ(shares[static_cast<std::size_t>(i)].weight, 0.25);
  }
}

// The corner (0.8, 0.8) is beyond the rim: three cells, not four. A disc within a cell touches no other.
TEST(GridVolumes, CellsThatTheDiscDoesNotTouchHaveNoShare) {
  const GridVolumes grid({-2, 0.8, 4}, {-2, 0.8, 4}, 1);
  EXPECT_EQ(shares_of(grid, {0, 0}, 1).size(), 3U);
  EXPECT_EQ(shares_of(grid, {-1, -1}, 1).size(), 1U);
  EXPECT_EQ(shares_of(grid, {5, 0}, 1).size(), 0U);
  EXPECT_EQ(shares_of(grid, {0, -3}, 1).size(), 0U);
}

TEST(GridVolumes, CentreWeightTakesTheCellThatHoldsTheCentre) {
  const GridVolumes grid({0, 1, 3}, {-1, 0, 2}, 1);
  EXPECT_EQ(grid.find({0, -1}), 0);  // left and lower edges belong to the cell
  EXPECT_EQ(grid.find({1, -0.5}), 1);
  EXPECT_EQ(grid.find({0.5, 0}), 2);
  EXPECT_EQ(grid.find({2.9, 1.9}), 3);
  EXPECT_EQ(grid.find({3, 1}), -1);
  EXPECT_EQ(grid.find({-0.1, 1}), -1);
  EXPECT_EQ(grid.find({1, 2}), -1);
  EXPECT_EQ(grid.find({1, -1.1}), -1);
}

TEST(GridVolumes, MeasureAndCoordinatesOfEachCell) {
  const GridVolumes grid({0, 1, 3}, {-1, 0, 2}, 0.5);
  const double expected[4][6] = {
      {0, 1, -1, 0, 0.5, -0.5}, {1, 3, -1, 0, 2, -0.5}, {0, 1, 0, 2, 0.5, 1}, {1, 3, 0, 2, 2, 1}};
  const double areas[] = {1, 2, 2, 4};
  for (int cell = 0; cell < 4; ++cell) {
    EXPECT_DOUBLE_EQ(grid.measure()[cell], 0.5 * areas[cell]);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(grid.coordinates()(cell, i), expected[cell][i]);
  }
}

TEST(GridVolumes, BadGridsAreRefused) {
  EXPECT_THROW(GridVolumes({1}, {0, 1}, 1), Error);
  EXPECT_THROW(GridVolumes({0, 1}, {0, 1, 1}, 1), Error);
  EXPECT_THROW(GridVolumes({0, 1}, {0, std::nan("")}, 1), Error);
  EXPECT_THROW(GridVolumes({0, 1}, {0, 1}, 0), Error);
  EXPECT_THROW(equal_grid_edges(1, 1, 2, "--box"), Error);
  EXPECT_THROW(equal_grid_edges(0, 1, 0, "--grid"), Error);
}

std::unique_ptr<const Volumes> grid_of(int cells_x, int cells_y) {
  return std::make_unique<const GridVolumes>(equal_grid_edges(-20, 20, cells_x, "--grid"),
                                             equal_grid_edges(-10, 10, cells_y, "--grid"), 0.5);
}

AverageSetup free_discs() {
  AverageSetup setup;
  setup.options.bulk_types = {1};
  setup.field_options.rings = false;
  return setup;
}

// Uniaxial compression along y of the triangular lattice d = 2, a = 1: y -> 0.98 y. Per disc the contacts
//   +-(2, 0): no overlap (0 to rounding), n = e_x
//   +-(1, 0.98 s), +-(-1, 0.98 s), s = sqrt(3): length l = sqrt(1 + 0.98^2 3), overlap 2 - l
// sum n (x) n:  xx 2 + 4/l^2,  yy 4 0.98^2 3/l^2,  xy 0
// sum f (x) l = -4 k_n (2 - l)(1, 0.98^2 3)/l^2 in xx, yy;   19 free discs of V^p = pi h, V = 800 h, h = 0.5
TEST(GridAverage, UniaxialLatticeInABoxAsWorkedByHand) {
  LatticeSetup lattice{1, 2, 100, 3, Eigen::Matrix2d::Identity()};
  lattice.gradient(1, 1) = 0.98;
  const VolumeAverage average(make_lattice(lattice), grid_of(1, 1), free_discs());
  const double square = 0.98 * 0.98 * 3;
  const double length = std::sqrt(1 + square);
  const double nu = 19 * pi / 800;
  expect_measured(average.at("nu"), nu, rounding);
  expect_measured(average.at("coordination"), 6, rounding);
  expect_measured(average.at("F_xx"), nu * (2 + 4 / (length * length)), rounding);
  expect_measured(average.at("F_yy"), nu * 4 * square / (length * length), rounding);
  expect_measured(average.at("F_xy"), 0, rounding);
  const double stress = -19 * 4 * 100 * (2 - length) / (length * length) / (800 * 0.5);
  expect_measured(average.at("sigma_xx"), stress, rounding);
  expect_measured(average.at("sigma_yy"), stress * square, rounding);
  expect_measured(average.at("sigma_xy"), 0, rounding);
  expect_measured(average.at("sigma_yx"), 0, rounding);
}

// A sheared lattice with velocities that are linear in space.
Frame sheared_frame() {
  LatticeSetup lattice{1, 1.96, 50, 4, Eigen::Matrix2d::Identity()};
  lattice.gradient << 1, 0.02, 0.005, 1.001;
  Frame frame = make_lattice(lattice);
  for (Particle& particle : frame.particles) {
    particle.velocity = {1 + 0.5 * particle.position[1], -0.3 * particle.position[0]};
    particle.spin = particle.position[0];
  }
  return frame;
}

// Cells of equal area: the mean over cells of everything that is divided by V is that of the whole box.
TEST(GridAverage, CellsAddUpToTheWhole) {
  const VolumeAverage cells(sheared_frame(), grid_of(30, 17), free_discs());
  const VolumeAverage whole(sheared_frame(), grid_of(1, 1), free_discs());
  for (const std::string name : {"nu", "nu_3", "F_xx", "F_xy", "F_yy", "sigma_xx", "sigma_yx", "sigma_yy"}) {
    double sum = 0;
    for (int i = 0; i < 30 * 17; ++i) sum += cells.at(name, i) / (30 * 17);
    expect_measured(sum, whole.at(name), rounding, name);
  }
}

// By hand: v = (1 + y/2, -3x/10) and spin = x over a patch that is symmetric about 0 have the mean (1, 0), 0.
TEST(GridAverage, VelocityIsCartesian) {
  const VolumeAverage average(sheared_frame(), grid_of(1, 1), free_discs());
  expect_measured(average.at("v_x"), 1, rounding);
  expect_measured(average.at("v_y"), 0, rounding);
  expect_measured(average.at("spin"), 0, rounding);
}

// Everything turned by a quarter in a square box: x -> y, y -> -x, so xx and yy change places, xy -> -yx.
TEST(GridAverage, ComponentsTurnWithTheDiscs) {
  const auto square = [] {
    return std::make_unique<const GridVolumes>(std::vector<double>{-4, 4}, std::vector<double>{-4, 4}, 1);
  };
  const Frame frame = sheared_frame();
  Frame turned = frame;
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << 0, -1, 1, 0).finished();
  for (Particle& particle : turned.particles) {
    particle.position = turn * particle.position;
    particle.velocity = turn * particle.velocity;
  }
  for (Contact& contact : turned.contacts) {
    contact.normal = turn * contact.normal;
    contact.force = turn * contact.force;
  }
  const VolumeAverage before(frame, square(), free_discs());
  const VolumeAverage after(turned, square(), free_discs());
  for (const std::string name : {"F", "sigma", "sigma_kin", "eps"}) {
    expect_measured(after.at(name + "_yy"), before.at(name + "_xx"), rounding, name);
    expect_measured(after.at(name + "_xx"), before.at(name + "_yy"), rounding, name);
    expect_measured(after.at(name + "_yx"), -before.at(name + "_xy"), rounding, name);
    expect_measured(after.at(name + "_xy"), -before.at(name + "_yx"), rounding, name);
  }
  expect_measured(after.at("v_y"), before.at("v_x"), rounding);
  expect_measured(after.at("v_x"), -before.at("v_y"), rounding);
  expect_measured(after.at("nu"), before.at("nu"), rounding);
}

TEST(GridAverage, FieldsThatNeedRingsAreLeftOutAndRefusedByName) {
  FieldOptions options;
  options.rings = false;
  for (const ListedField& listed : make_fields({"all"}, options))
    EXPECT_FALSE(listed.shown && listed.field->name().starts_with("velocity_gradient"));
  EXPECT_THROW(make_fields({"velocity_gradient"}, options), Error);
  EXPECT_THROW(make_fields({"spin", "velocity_gradient_fit"}, options), Error);
}

}  // namespace
}  // namespace mikromakro
