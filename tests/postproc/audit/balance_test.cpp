// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "audit/contact_balance.h"
#include "audit/normal_forces.h"
#include "audit/ring_balance.h"
#include "averaging/volumes/ring_volumes.h"
#include "measured_error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

Contact contact_between(int first, int second, const Eigen::Vector2d& normal, const Eigen::Vector2d& force) {
  Contact contact;
  contact.id1 = first + 1;
  contact.id2 = second < 0 ? 0 : second + 1;
  contact.index1 = first;
  contact.index2 = second;
  contact.normal = normal;
  contact.force = force;
  contact.overlap = 0.2;
  return contact;
}

// A free disc (radius 1) at (5, 0) on a wheel's disc (type 3) at (3.3, 0); centre (1, 0). The contact point
// is 1 - 0.1 from the free disc's centre: (4.1, 0), arm 3.1. Force on the free disc (7, -2), on the wheel
// (-7, 2): torque 3.1 * 2. On the inner wall instead the point is at 5 - (1 - 0.2) = 4.2, arm 3.2. The free
// disc is the second of the row in the first frame, the first in the second one.
TEST(ContactBalance, TorqueOnTheWheelAsWorkedByHand) {
  Frame frame;
  frame.particles = {make_disc(1, {3.3, 0}, 0.9, 3), make_disc(2, {5, 0}, 1, 1)};
  frame.contacts = {contact_between(0, 1, {1, 0}, {-7, 2})};
  ContactBalance on_disc({{1, 0}, {1}, {3}});
  on_disc.add(frame);
  expect_measured(on_disc.wheel_torque(), 6.2, rounding);
  frame.contacts = {contact_between(1, 0, {-1, 0}, {7, -2})};
  on_disc.add(frame);
  expect_measured(on_disc.wheel_torque(), 6.2, rounding);

  ContactBalance on_wall({{1, 0}, {}, {}});
  frame.contacts = {contact_between(1, -1, {-1, 0}, {7, -2})};
  on_wall.add(frame);
  expect_measured(on_wall.wheel_torque(), 6.4, rounding);

  ContactBalance nothing({{1, 0}, {1}, {}});
  frame.contacts.clear();
  nothing.add(frame);
  EXPECT_TRUE(std::isnan(nothing.wheel_torque()));
  EXPECT_TRUE(std::isnan(nothing.force_residual()));
}

// Edges of 0.1032 + k 0.0075 are rounded: the distance of the second ring from the first edge is below
// 0.0075.
TEST(RingBalances, AMarginOfOneRingLeavesOutOneOnEitherSide) {
  constexpr int count = 10;
  Table table;
  for (const char* name : {"r_inner", "r_outer", "r", "sigma_rr", "sigma_phiphi", "sigma_phir"})
    table.columns.push_back({name, "", "-", ""});
  table.rows = Rows::Zero(count, 6);
  const std::vector<double> edges = equal_ring_edges(0.1032, 0.1782, count);
  for (int i = 0; i < count; ++i) {
    table.rows(i, 0) = edges[static_cast<std::size_t>(i)];
    table.rows(i, 1) = edges[static_cast<std::size_t>(i) + 1];
    table.rows(i, 2) = (table.rows(i, 0) + table.rows(i, 1)) / 2;
  }
  const std::vector<RingBalance> rings = ring_balances(table, 0.006, 0.0075);
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(rings[static_cast<std::size_t>(i)].counts, i > 0 && i < count - 1) << i;
}

// The same pair around the corner of a periodic box of 10 m: the free disc at x = 5 is at -5 or 15, and 20 m
// up.
TEST(ContactBalance, TorqueOnAWheelInAPeriodicBoxIsThatOfTheImageBesideIt) {
  Frame frame;
  frame.box = {{-5, -5}, {5, 5}, {true, true}};
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(5, 0), {-5, 0}, {15, 20}}) {
    frame.particles = {make_disc(1, {3.3, 0}, 0.9, 3), make_disc(2, place, 1, 1)};
    frame.contacts = {contact_between(0, 1, {1, 0}, {-7, 2})};
    ContactBalance balance({{1, 0}, {1}, {3}});
    balance.add(frame);
    expect_measured(balance.wheel_torque(), 6.2, rounding);
  }
}

// Overlaps of 0.2 and k_n = 50: 10 N each. Forces of 10 and 13 N: deviation 3/20, slope 23/0.4; tangential
// forces and walls do not count. Doubled, reversed, one of them reversed: 26/20, 43/20, 23/20.
TEST(NormalForces, BesideOverlapsAsWorkedByHand) {
  const auto forces = [](double first, double second, double k_n) {
    Frame frame;
    for (int i = 0; i < 3; ++i) frame.particles.push_back(make_disc(i + 1, {1.8 * i, 0}, 1));
    frame.contacts = {contact_between(0, 1, {1, 0}, {-first, 5}), contact_between(1, 2, {0, 1}, {3, -second}),
                      contact_between(2, -1, {1, 0}, {-1000, 0})};
    NormalForces sums(k_n);
    sums.add(frame);
    return sums;
  };
  expect_measured(forces(10, 10, 50).deviation(), 0, rounding);
  expect_measured(forces(10, 13, 50).deviation(), 0.15, rounding);
  expect_measured(forces(10, 13, 50).stiffness(), 57.5, rounding);
  expect_measured(forces(20, 26, 50).deviation(), 1.3, rounding);
  expect_measured(forces(-10, -13, 50).deviation(), 2.15, rounding);
  expect_measured(forces(-10, 13, 50).deviation(), 1.15, rounding);
  expect_measured(forces(-10, 13, 50).pulling(), 10.0 / 23, rounding);
  expect_measured(forces(-10, -13, 50).pulling(), 1, rounding);
  const double unknown = std::nan("");
  EXPECT_FALSE(forces(10, 10, unknown).stiffness_is_known());
  expect_measured(forces(10, 10, unknown).stiffness(), 50, rounding);
  EXPECT_TRUE(std::isnan(NormalForces(50).deviation()));
  EXPECT_TRUE(std::isnan(NormalForces(50).stiffness()));
}

// Three discs in a row, forces 10 and 4 between them: sums 10, 6 and 4, mean 20/3; each force belongs to two
// discs, mean 7.
TEST(ContactBalance, ForceResidualAsWorkedByHand) {
  Frame frame;
  for (int i = 0; i < 3; ++i) frame.particles.push_back(make_disc(i + 1, {1.8 * i, 0}, 1));
  frame.particles.push_back(make_disc(9, {0, 10}, 1));  // without contacts: does not count
  frame.contacts = {contact_between(0, 1, {1, 0}, {-10, 0}), contact_between(1, 2, {1, 0}, {-4, 0})};
  ContactBalance balance({{0, 0}, {}, {}});
  balance.add(frame);
  expect_measured(balance.force_residual(), 20.0 / 21, rounding);
}

// The stress of a thick-walled ring, sigma_rr = A - B/r^2, sigma_phiphi = A + B/r^2, sigma_phir = C/r^2: it
// is in equilibrium at every r. r sigma_rr is A r - B/r, whose slope by differences has an error of order
// (dr/r)^2.
Table thick_ring(double extra) {
  Table table;
  for (const char* name : {"r_inner", "r_outer", "r", "sigma_rr", "sigma_phiphi", "sigma_phir"})
    table.columns.push_back({name, "", "", ""});
  constexpr int rings = 100;
  table.rows.resize(rings, 6);
  for (int i = 0; i < rings; ++i) {
    const double r = 1 + 0.01 * (i + 0.5);
    table.rows.row(i) << r - 0.005, r + 0.005, r, -3 - 2 / (r * r), -3 + 2 / (r * r), -0.5 / (r * r);
  }
  table.rows(0, 5) += extra;
  return table;
}

TEST(RingBalance, ThickWalledRingIsInEquilibrium) {
  const auto rings = ring_balances(thick_ring(0), 2, 0);
  // 2 pi r^2 h sigma_phir = 2 pi 2 (-0.5)
  const double torque = -2 * std::numbers::pi;
  expect_measured(torque_deviation(rings, torque), 0, rounding);
  // 2/r has the third derivative 12/r^4, so central slopes are off by 12 (0.01)^2/6 = 2e-4 of a pressure
  // of 3.
  EXPECT_LT(radial_deviation(rings), 1e-4);
  EXPECT_TRUE(std::isnan(torque_deviation(rings, std::nan(""))));
}

TEST(RingBalance, RingsAtWallsAreNotJudged) {
  const double torque = -2 * std::numbers::pi;
  EXPECT_GT(torque_deviation(ring_balances(thick_ring(0.1), 2, 0), torque), 0.1);
  EXPECT_LT(torque_deviation(ring_balances(thick_ring(0.1), 2, 0.01), torque), rounding);
  EXPECT_FALSE(ring_balances(thick_ring(0), 2, 0.01).back().counts);
  EXPECT_TRUE(std::isnan(torque_deviation(ring_balances(thick_ring(0), 2, 0.6), torque)));
}

}  // namespace
}  // namespace mikromakro
