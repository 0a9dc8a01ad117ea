// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/box_balance.h"

#include <gtest/gtest.h>

#include <numbers>

#include "audit/cell_balance.h"
#include "averaging/volumes/grid_volumes.h"
#include "measured_error.h"
#include "model/error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-14;
constexpr double h = 0.5;

BoxBalance balance_of(const Frame& frame, const std::vector<int>& bulk_types) {
  const Rectangle box = wall_rectangle(frame);
  AverageSetup setup;
  setup.weight = "centre";
  setup.options = {bulk_types, Branch::contact};
  setup.fields = {"stress"};
  const VolumeAverage average(
      frame,
      std::make_unique<const GridVolumes>(std::vector<double>{box.low[0], box.high[0]},
                                          std::vector<double>{box.low[1], box.high[1]}, h),
      setup);
  Eigen::Matrix2d stress;
  stress << average.at("sigma_xx"), average.at("sigma_xy"), average.at("sigma_yx"), average.at("sigma_yy");
  BoxBalance balance;
  balance.add(box, h, box.size().prod() * h * stress, box_load(frame, box, bulk_types));
  return balance;
}

// Two by two discs of radius 1 at (+-0.95, +-0.95) between walls at +-1.85, all overlaps 0.1. Each row
// carries 2 N from wall to wall, each column 3 N, and every face a shear force: faces with the outward normal
// x feel `shear` along y, faces with the normal y along x.
class Sample {
 public:
  explicit Sample(double shear) : shear_(shear) {
    for (int i = 0; i < 4; ++i)
      frame.particles.push_back(make_disc(i + 1, {i % 2 == 0 ? -0.95 : 0.95, i < 2 ? -0.95 : 0.95}, 1));
    add(0, 1, {1, 0}, 2);
    add(3, 2, {-1, 0}, 2);
    add(0, 2, {0, 1}, 3);
    add(1, 3, {0, 1}, 3);
    for (int i = 0; i < 4; ++i) {
      add_wall(i, i % 2 == 0 ? -1 : -2, {i % 2 == 0 ? -1 : 1, 0}, 2);
      add_wall(i, i < 2 ? -3 : -4, {0, i < 2 ? -1 : 1}, 3);
    }
  }

  BoxBalance balance(const std::vector<int>& bulk_types = {}) const { return balance_of(frame, bulk_types); }

  Frame frame;

 private:
  void add(int first, int second, const Eigen::Vector2d& normal, double force) {
    Contact contact;
    contact.id1 = first + 1;
    contact.id2 = second + 1;
    contact.index1 = first;
    contact.index2 = second;
    contact.normal = normal;
    contact.overlap = 0.1;
    contact.force = -force * normal + shear_ * normal.reverse();
    frame.contacts.push_back(contact);
  }
  void add_wall(int disc, int wall, const Eigen::Vector2d& normal, double force) {
    add(disc, -2, normal, force);
    frame.contacts.back().id2 = wall;
    frame.contacts.back().index2 = -1;
  }

  double shear_;
};

// A row of 2 N through branches of 0.9, 0.95, 0.95, 0.9: sigma_xx = -2 rows * 2 * 3.7/V, V = 3.7^2 h.
TEST(BoxBalance, OfALatticeAsWorkedByHand) {
  const BoxBalance balance = Sample(0.25).balance();
  Eigen::Matrix2d expected;
  expected << -4, 0.5, 0.5, -6;
  expected /= 3.7 * h;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      expect_measured(balance.volume_stress()(i, j), expected(i, j), rounding);
      expect_measured(balance.boundary_stress()(i, j), expected(i, j), rounding);
    }
    for (const int wall : {0, 1}) expect_measured(balance.wall(wall).stress[i], expected(i, 0), rounding);
    for (const int wall : {2, 3}) expect_measured(balance.wall(wall).stress[i], expected(i, 1), rounding);
  }
  expect_measured(balance.wall(1).force[0], -4, rounding);
  expect_measured(balance.wall(2).area, 3.7 * h, rounding);
  expect_measured(balance.stress_deviation(), 0, rounding);
  expect_measured(balance.wall_deviation(), 0, rounding);
  expect_measured(balance.wall_residual(), 0, rounding);
  expect_measured(balance.friction(), 8 * 0.25 / 20, rounding);
  expect_measured(Sample(0).balance().friction(), 0, rounding);
  expect_measured(balance.box().high[1], 1.85, rounding);
}

// 0.6 N more on the disc at (0.95, 0.95) from the right wall: the branch (0.9, 0) is short of the contact
// point (1.85, 0.95), measured from the middle, by (0.95, 0.95), so that sigma_xx and sigma_xy differ by
// 0.6 * 0.95/V; the pressure is (4 + 6)/2/(3.7 h) + 0.6 * 0.9/2/V. The wall's own stress is off by
// 0.6/(3.7 h) - 0.6 * 0.9/V.
TEST(BoxBalance, IsOffByAWrongForceAsMuchAsWorkedByHand) {
  Sample sample(0);
  for (Contact& contact : sample.frame.contacts)
    if (contact.id1 == 4 && contact.id2 == -2) contact.force[0] -= 0.6;
  const BoxBalance balance = sample.balance();
  const double volume = 3.7 * 3.7 * h;
  const double pressure = 5 / (3.7 * h) + 0.27 / volume;
  expect_measured(balance.stress_deviation(), 0.57 / volume / pressure, rounding);
  expect_measured(balance.wall_deviation(), (0.6 / (3.7 * h) - 0.54 / volume) / pressure, rounding);
  expect_measured(balance.wall_residual(), 0.6 / (0.25 * (4 + 4.6 + 6 + 6)), rounding);
}

// Discs 2 and 4 are wall discs: the boundary of the other two is where they touch them.
TEST(BoxBalance, DiscsThatAreNotAveragedAreBoundary) {
  Sample sample(0.25);
  sample.frame.particles[1].type = 2;
  sample.frame.particles[3].type = 2;
  const BoxBalance balance = sample.balance({1});
  // Half of the columns, rows from -1.85 to 0.
  expect_measured(balance.volume_stress()(0, 0), -2.0 * 2 * 1.85 / (3.7 * 3.7 * h), rounding);
  expect_measured(balance.stress_deviation(), 0, rounding);
  expect_measured(balance.wall(1).force.norm(), 0, 0);
}

TEST(BoxBalance, SeveralFramesAreMeans) {
  const BoxBalance one = Sample(0.25).balance();
  BoxBalance both;
  const Rectangle box = one.box();
  const double volume = box.size().prod() * h;
  both.add(box, h, volume * one.volume_stress(), box_load(Sample(0.25).frame, box, {}));
  const Rectangle wide{{2 * box.low[0], box.low[1]}, {2 * box.high[0], box.high[1]}};
  both.add(wide, h, Eigen::Matrix2d::Zero(), box_load(Sample(0).frame, wide, {}));
  EXPECT_EQ(both.frames(), 2);
  expect_measured(both.box().high[0], 1.5 * 1.85, rounding);
  // V sigma over V + 2 V; the wide box has side walls as high as the other's, and bottom and top twice as
  // long.
  expect_measured(both.volume_stress()(0, 0), -4 / (3.7 * h) / 3, rounding);
  expect_measured(both.wall(0).stress[0], -8 / (2 * 3.7 * h), rounding);
  expect_measured(both.wall(2).stress[1], -12 / (3 * 3.7 * h), rounding);
}

// Two rows between bottom and top at +-1.85, periodic along x with 3.8 m: the discs at x = +-0.95 touch their
// neighbours on both sides, each row carries 2 N, each column 3 N, and shear as above. sigma_xx = -2 rows * 2
// N * 3.8 m/V, V = 3.8 * 3.7 h; the columns of the normal y are as before over the length 3.8.
Frame between_two_walls(double shear) {
  Frame frame = Sample(shear).frame;
  frame.box = {{-1.9, -9}, {1.9, 9}, {true, false}};
  // In place of left and right walls: disc 1 and 2, 3 and 4 through the boundary.
  std::erase_if(frame.contacts, [](const Contact& c) { return c.id2 == -1 || c.id2 == -2; });
  for (const int row : {0, 1}) {
    Contact contact = frame.contacts[0];
    contact.id1 = 2 * row + 2;
    contact.id2 = 2 * row + 1;
    contact.index1 = 2 * row + 1;
    contact.index2 = 2 * row;
    contact.force = {-2, shear};
    frame.contacts.push_back(contact);
  }
  return frame;
}

TEST(BoxBalance, OfTwoWallsInAPeriodicBoxAsWorkedByHand) {
  for (const double moved : {0.0, 0.97, -2.5}) {
    Frame frame = between_two_walls(0.25);
    for (Particle& particle : frame.particles) {
      particle.position.x() += moved;
      particle.position.x() -= 3.8 * std::floor((particle.position.x() + 1.9) / 3.8);
    }
    const Rectangle box = wall_rectangle(frame);
    EXPECT_EQ(box.low.x(), -1.9);
    expect_measured(box.high.y(), 1.85, rounding);
    const BoxBalance balance = balance_of(frame, {});
    const double h_x = 3.8 * h, h_y = 3.7 * h;
    expect_measured(balance.volume_stress()(0, 0), -4 / h_y, rounding);
    expect_measured(balance.volume_stress()(1, 1), -6 / h_x, rounding);
    expect_measured(balance.boundary_stress()(0, 1), 0.5 / h_x, rounding);
    expect_measured(balance.boundary_stress()(1, 1), -6 / h_x, rounding);
    EXPECT_TRUE(std::isnan(balance.boundary_stress()(0, 0)) && std::isnan(balance.boundary_stress()(1, 0)));
    EXPECT_TRUE(balance.is_open(0) && !balance.is_open(1));
    EXPECT_TRUE(!balance.may_have_wall(0) && !balance.may_have_wall(1) && balance.may_have_wall(2));
    expect_measured(balance.stress_deviation(), 0, rounding);
    expect_measured(balance.wall_deviation(), 0, rounding);
    expect_measured(balance.wall_residual(), 0, rounding);
    expect_measured(disc_area_inside(frame, box, {}), 4 * std::numbers::pi, rounding);
  }
}

TEST(BoxBalance, BesideWallsAPeriodicBoxIsBalancedAsAWhole) {
  const Frame frame = between_two_walls(0);
  EXPECT_THROW(box_load(frame, {{-1.8, -1.85}, {1.8, 1.85}}, {}), Error);
  EXPECT_NO_THROW(box_load(frame, {{0, -1.85}, {3.8, 1.85}}, {}));
}

TEST(BoxBalance, OfAPeriodicBoxHasNoBoundary) {
  Frame frame = between_two_walls(0.25);
  frame.box = {{-1.9, -1.9}, {1.9, 1.9}, {true, true}};
  std::erase_if(frame.contacts, [](const Contact& c) { return c.with_wall(); });
  for (const int column : {0, 1}) {
    Contact contact = frame.contacts[0];
    contact.id1 = column + 3;
    contact.id2 = column + 1;
    contact.index1 = column + 2;
    contact.index2 = column;
    contact.normal = {0, 1};
    contact.force = {0.25, -3};
    frame.contacts.push_back(contact);
  }
  const Rectangle box = wall_rectangle(frame);
  EXPECT_EQ(box.high.y(), 1.9);
  const BoxBalance balance = balance_of(frame, {});
  expect_measured(balance.volume_stress()(1, 1), -6 / (3.8 * h), rounding);
  EXPECT_TRUE(balance.is_open(0) && balance.is_open(1));
  EXPECT_FALSE(balance.has_boundary());
  EXPECT_FALSE(balance.has_walls());
}

// Walls on all sides within a box that is called periodic: nothing crosses, and all is as without.
TEST(BoxBalance, OfWallsWithinAPeriodicBoxIsThatOfTheWalls) {
  Sample sample(0.25);
  sample.frame.box = {{-9, -9}, {9, 9}, {true, true}};
  expect_measured(sample.balance().stress_deviation(), 0, rounding);
  expect_measured(sample.balance().wall_deviation(), 0, rounding);
  EXPECT_TRUE(sample.balance().may_have_wall(0));
}

TEST(BoxBalance, BoundariesThatChangeAreAnError) {
  const Frame frame = Sample(0).frame;
  BoxBalance balance = balance_of(frame, {});
  BoxLoad load = box_load(frame, wall_rectangle(frame), {});
  load.periodic = {true, false};
  EXPECT_THROW(balance.add(wall_rectangle(frame), h, Eigen::Matrix2d::Zero(), load), Error);
}

TEST(WallRectangle, NeedsAllFourWallsInTheirOrder) {
  Sample sample(0);
  std::erase_if(sample.frame.contacts, [](const Contact& contact) { return contact.id2 == -3; });
  EXPECT_THROW(wall_rectangle(sample.frame), Error);
  Sample swapped(0);
  for (Contact& contact : swapped.frame.contacts)
    if (contact.id2 == -1 || contact.id2 == -2) contact.id2 = -3 - contact.id2;
  EXPECT_THROW(wall_rectangle(swapped.frame), Error);
}

TEST(DiscAreaInside, CountsCentresOfAveragedDiscs) {
  const Frame frame = Sample(0).frame;
  expect_measured(disc_area_inside(frame, {{-1, -1}, {1, 1}}, {}), 4 * std::numbers::pi, rounding);
  expect_measured(disc_area_inside(frame, {{-0.95, -1}, {0.95, 1}}, {1}), 2 * std::numbers::pi, rounding);
  expect_measured(disc_area_inside(frame, {{-1, -1}, {1, 1}}, {2}), 0, 0);
}

// Four by three cells of 0.5 by 0.25 with linear stresses, whose differences are exact:
// sigma_xx = 3 x + 5 y - 7, sigma_xy = 2 x - y, sigma_yx = x + y, sigma_yy = 4 y - 9, t = (-1.5, -4.75):
// div sigma + t = (3 - 1 - 1.5, 1 + 4 - 4.75).
TEST(CellBalance, DivergenceOfLinearStresses) {
  Table table;
  for (const char* name : {"x_min", "x_max", "y_min", "y_max", "x", "y", "sigma_xx", "sigma_xy", "sigma_yx",
                           "sigma_yy", "wall_force_density_x", "wall_force_density_y"})
    table.columns.push_back({name, "", "", ""});
  table.rows.resize(12, 12);
  for (int cell = 0; cell < 12; ++cell) {
    const int column = cell % 4;
    const int row = cell / 4;
    const double x = 0.5 * column;
    const double y = 0.25 * row;
    table.rows.row(cell) << x - 0.25, x + 0.25, y - 0.125, y + 0.125, x, y, 3 * x + 5 * y - 7, 2 * x - y,
        x + y, 4 * y - 9, -1.5, -4.75;
  }
  const auto cells = cell_balances(table, 4);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].x, 0.5);
  EXPECT_EQ(cells[1].x, 1);
  EXPECT_EQ(cells[1].y, 0.25);
  for (const CellBalance& cell : cells) {
    expect_measured(cell.left[0], 0.5, rounding);
    expect_measured(cell.left[1], 0.25, rounding);
  }
  // Means of x and y are 0.75 and 0.25: pressure -(2.25 + 1.25 - 7 + 1 - 9)/2.
  expect_measured(momentum_deviation(table, 4), std::hypot(0.5, 0.25) * 0.5 / 5.75, rounding);
  EXPECT_TRUE(std::isnan(momentum_deviation(table, 12)));
}

}  // namespace
}  // namespace mikromakro
