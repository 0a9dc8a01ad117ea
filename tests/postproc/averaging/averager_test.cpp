// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/averager.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "averaging/time_average.h"
#include "measured_error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-14;  // a handful of terms of size 1

Contact wall_contact(const Particle& disc, const Eigen::Vector2d& normal, const Eigen::Vector2d& force) {
  Contact contact;
  contact.id1 = disc.id;
  contact.id2 = 0;
  contact.index1 = 0;
  contact.normal = normal;
  contact.force = force;
  contact.overlap = 0.1;
  return contact;
}

// A disc at (0, 3), radius 2, pressed by the wall below it: n = (0, -1) = -e_r, force (1, 4) = 4 e_r - 1
// e_phi on the disc. f (x) l with l = -2 e_r: sigma_rr = -8/V, sigma_phir = +2/V; V^p n (x) n = 4 pi in F_rr;
// V = 100 pi.
TEST(Averager, WallContactBelongsToItsDisc) {
  Frame frame;
  frame.particles = {make_disc(4, {0, 3}, 2)};
  frame.contacts = {wall_contact(frame.particles[0], {0, -1}, {1, 4})};
  const RingAverage average(frame, {{0, 10}});
  expect_measured(average.at("coordination"), 1, rounding);
  expect_measured(average.at("F_rr"), 0.04, rounding);
  expect_measured(average.at("F_phiphi"), 0, rounding);
  expect_measured(average.at("sigma_rr"), -8 / (100 * pi), rounding);
  expect_measured(average.at("sigma_phir"), 2 / (100 * pi), rounding);
  expect_measured(average.at("sigma_rphi"), 0, rounding);
  expect_measured(average.at("sigma_phiphi"), 0, rounding);
  // To the contact point: 2 - 0.1, the whole overlap since the wall does not deform.
  const RingAverage contact(frame, {{0, 10}, {0, 0}, 1, "sliced", {{}, Branch::contact}});
  expect_measured(contact.at("sigma_rr"), -7.6 / (100 * pi), rounding);
}

// A free disc (type 1) and a wall disc (type 2) in contact: the wall disc has no average of its own, the
// contact is the free disc's, in either place of the row.
TEST(Averager, WallDiscsGiveTheirContactsToFreeDiscs) {
  Frame frame;
  frame.particles = {make_disc(1, {3, 0}, 1, 1), make_disc(2, {4.9, 0}, 1, 2)};
  for (const bool free_disc_first : {true, false}) {
    frame.contacts = {free_disc_first ? make_contact(frame, 0, 1, 100) : make_contact(frame, 1, 0, 100)};
    const RingAverage average(frame, {{0, 10}, {0, 0}, 1, "sliced", {{1}, Branch::radius}});
    expect_measured(average.at("nu"), 0.01, rounding);
    expect_measured(average.at("coordination"), 1, rounding);
    expect_measured(average.at("F_rr"), 0.01, rounding);
    expect_measured(average.at("sigma_rr"), -10 / (100 * pi), rounding);  // k_n overlap = 100 * 0.1, l = 1
  }
}

// Sums the forces and normals of all contacts as they are: odd in the side from which a contact is seen,
// which no tensor f (x) l is.
class ContactProbe : public Field {
 public:
  std::string_view name() const override { return "probe"; }
  std::vector<Column> columns(const Axes& axes) const override { return tensor_columns("probe", axes, {}); }
  int sums() const override { return 4; }
  void add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override {
    for (const DiscContact& contact : contacts) {
      quantity[0] += contact.normal[0];
      quantity[1] += contact.normal[1];
      quantity[2] += contact.force[0];
      quantity[3] += contact.force[1];
    }
  }
  void solve(const VolumeData& /*volumes*/, const ConstRowsRef& sums, RowsRef columns) const override {
    columns = sums;
  }
};

// Discs at (3, 0) and (4.9, 0), one ring each; k_n overlap = 10: n = e_r, f = -10 e_r for the inner one, the
// opposite for the outer one.
TEST(Averager, EachDiscSeesItsContactFromItsOwnSide) {
  Frame frame;
  frame.particles = {make_disc(1, {3, 0}, 1), make_disc(2, {4.9, 0}, 1)};
  frame.contacts = {make_contact(frame, 0, 1, 100)};
  FieldList fields;
  fields.push_back({std::make_unique<const ContactProbe>()});
  const Averager averager(
      std::make_unique<const RingVolumes>(Eigen::Vector2d(0, 0), std::vector<double>{2, 4, 6}, 1),
      make_weight("centre"), std::move(fields), {});
  const Rows sums = averager.frame_sums(frame);
  constexpr double of_positions = 1e-12;  // overlap = 2 - 1.9 has lost two digits, times 100
  expect_measured(sums(0, 0), 1, rounding);
  expect_measured(sums(1, 0), -1, rounding);
  expect_measured(sums(0, 2), -10, of_positions);
  expect_measured(sums(1, 2), 10, of_positions);
}

TEST(Averager, EmptyRingHasNoVelocityButNoDensityEither) {
  Frame frame;
  frame.particles = {make_disc(1, {3, 0}, 1)};
  const RingAverage average(frame, {{5, 6}});
  for (const std::string name : {"nu", "nu_1", "F_rr", "sigma_rr"}) EXPECT_EQ(average.at(name), 0) << name;
  for (const std::string name : {"v_r", "v_phi", "spin", "coordination", "sigma_kin_rr"})
    EXPECT_TRUE(std::isnan(average.at(name))) << name;
}

// Disc of radius 1 at r = 3, edges 0, 3, 6. By centre all of it is in the outer ring (3 belongs to it): nu =
// pi/27 pi. Sliced, the inner ring has the lens of d = 3, a = 1, R = 3 (0.4471 of the disc by the formula of
// the areas' own test).
TEST(Averager, WeightsDifferForADiscAcrossAnEdge) {
  Frame frame;
  frame.particles = {make_disc(1, {0, -3}, 1)};
  const RingAverage centre(frame, {{0, 3, 6}, {0, 0}, 1, "centre"});
  EXPECT_EQ(centre.at("nu", 0), 0);
  expect_measured(centre.at("nu", 1), 1.0 / 27, rounding);
  const RingAverage sliced(frame, {{0, 3, 6}});
  const double alpha = std::acos(1.0 / 6);     // cos = a/(2 d)
  const double beta = 2 * std::asin(1.0 / 6);  // chord of length a seen from the origin
  const double lens =
      alpha - std::sin(alpha) * std::cos(alpha) + 9 * (beta - std::sin(beta) * std::cos(beta));
  expect_measured(sliced.at("nu", 0), lens / (9 * pi), rounding);
  expect_measured(sliced.at("nu", 1), (pi - lens) / (27 * pi), rounding);
}

// Two frames: one disc of area pi and v = 1, then one of area 4 pi and v = 6. Sums first: v = (1 + 24)/5 = 5,
// not 3.5.
TEST(TimeAverage, SumsAreAveragedBeforeTheRatios) {
  const Averager averager(
      std::make_unique<const RingVolumes>(Eigen::Vector2d(0, 0), std::vector<double>{0, 10}, 1),
      make_weight("sliced"), make_fields({"solid_fraction", "velocity"}), {});
  Frame first;
  Frame second;
  first.particles = {make_disc(1, {3, 0}, 1)};
  second.particles = {make_disc(1, {3, 0}, 2)};
  first.particles[0].velocity = {1, 0};
  second.particles[0].velocity = {6, 0};
  TimeAverage average;
  average.add(averager.frame_sums(first));
  average.add(averager.frame_sums(second));
  const Table table = averager.solve(average.mean());
  ASSERT_EQ(table.columns.size(),
            9U);  // 3 of the rings, 4 + 2 of the fields: what was not asked for is not there
  expect_measured(table.rows(0, 3), 0.025, rounding);
  expect_measured(table.rows(0, 7), 5, rounding);
}

}  // namespace
}  // namespace mikromakro
