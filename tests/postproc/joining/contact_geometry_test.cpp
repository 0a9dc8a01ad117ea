// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "joining/joined_rows.h"
#include "model/error.h"

namespace mikromakro {
namespace {

using enum ContactColumn;

TEST(JoinContacts, DerivesNormalAndOverlapFromTheDiscs) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  const Contact contact = join_one(rows, two_discs(), box_of_ten(false));
  EXPECT_DOUBLE_EQ(contact.normal[0], 0.6);
  EXPECT_DOUBLE_EQ(contact.normal[1], 0.8);
  EXPECT_DOUBLE_EQ(contact.overlap, 0.25);
}

// One disc displaced by a fifth of the smaller radius in one of the two dumps, along the contact and across
// it.
TEST(JoinContacts, SeesADiscThatIsElsewhereInOneOfTheDumps) {
  const std::vector<Value> geometry = {{id1, 900}, {id2, 4}, {nx, 0.6}, {ny, 0.8}, {overlap, 0.25}};
  EXPECT_EQ(refusal(geometry), "");
  for (const Eigen::Vector2d& shift : {Eigen::Vector2d(0.06, 0.08), Eigen::Vector2d(-0.08, 0.06)}) {
    auto discs = two_discs();
    discs[1].position += shift;
    EXPECT_NE(refusal(geometry, discs).find("is not that of discs 900 and 4"), std::string::npos);
  }
}

TEST(JoinContacts, NormalOverlapAndDistanceAreThoseOfTheDiscs) {
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {nx, -0.6}, {ny, -0.8}}).find("nx ny = 0.6 0.8"),
            std::string::npos);
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {overlap, 0.251}}).find("overlap is not"), std::string::npos);
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {overlap, -1e308}}).find("overlap is not"), std::string::npos);
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {dist, 1.251}}).find("dist is not"), std::string::npos);
  EXPECT_EQ(refusal({{id1, 900}, {id2, 4}, {dist, 1.25}}), "");
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}, {dist, 1.250001}});  // within six digits: taken as it is told
  EXPECT_NEAR(join_one(rows, two_discs(), box_of_ten(false)).overlap, 0.249999, 1e-15);
}

// Two discs of radius 0.5 whose centres are 1.05 apart.
TEST(JoinContacts, DiscsThatDoNotTouchAreNoContactUnlessTheUserSaysSo) {
  const std::vector<Particle> apart = {disc(1, 0, 0, 0.5), disc(2, 1.05, 0, 0.5)};
  ContactRows rows;
  add_row(rows, {{id1, 1}, {id2, 2}, {fx, 0}, {fy, 0}});
  Notes notes;
  EXPECT_TRUE(join_all(rows, apart, box_of_ten(false), {false, &notes, 7}).empty());
  EXPECT_TRUE(join_all(rows, apart, box_of_ten(false), {true, &notes, 7}).empty());
  ASSERT_EQ(notes.lines().size(), 1U);
  EXPECT_NE(notes.lines()[0].find("left out (step 7)"), std::string::npos) << notes.lines()[0];
  const std::vector<Value> pulled = {{id1, 1}, {id2, 2}, {fx, 3}, {fy, 0}};
  EXPECT_NE(refusal(pulled, apart).find("--distant-contacts"), std::string::npos);
  EXPECT_EQ(refusal(pulled, apart, false, true), "");
  // A touch without force (a dashpot that pulls, cut off) is a contact.
  ContactRows touching;
  add_row(touching, {{id1, 900}, {id2, 4}, {fx, 0}, {fy, 0}});
  EXPECT_EQ(join_all(touching, two_discs(), box_of_ten(false)).size(), 1U);
}

// n = (0.6, 0.8), t = (-0.8, 0.6): f = -10 n + 1 t; shear = 3e-6 t.
TEST(JoinContacts, TakesForceAndSpringFromWhatIsGiven) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}, {fn, 10}, {ft, 1}, {shearx, -2.4e-6}, {sheary, 1.8e-6}});
  const Contact contact = join_one(rows, two_discs(), box_of_ten(false));
  EXPECT_NEAR(contact.force[0], -6.8, 1e-14);
  EXPECT_NEAR(contact.force[1], -7.4, 1e-14);
  EXPECT_NEAR(contact.spring, 3e-6, 1e-20);
}

// In the columns of a spring: a normal force, along n.
TEST(JoinContacts, AForceAlongTheNormalIsNoSpring) {
  EXPECT_NE(
      refusal({{id1, 900}, {id2, 4}, {fn, 10}, {ft, 1}, {shearx, -6}, {sheary, -8}}).find("not a spring"),
      std::string::npos);
}

// 31 discs in a row along x: t = (0, 1), f_t = f_y. Springs of k_t = 80 N/m and all signs; in every fifth
// contact a dashpot turns f_t round.
TEST(JoinContacts, SpringsPullBackOnTheWhole) {
  std::vector<Particle> row;
  for (int i = 0; i <= 30; ++i) row.push_back(disc(i + 1, 0.9 * i, 5, 0.5));
  const auto springs = [](const auto& xi_of) {
    ContactRows rows;
    for (int i = 0; i < 30; ++i) {
      const double spring = (i % 2 == 0 ? 1e-3 : -1e-3) * (1 + i), turned = i % 5 == 0 ? -0.5 : 1;
      const double tangential = -80 * spring * turned;
      add_row(rows, {{id1, double(i + 1)},
                     {id2, double(i + 2)},
                     {fx, -10},
                     {fy, tangential},
                     {xi, xi_of(spring, tangential)}});
    }
    return rows;
  };
  const Box box = {{-1, 0}, {40, 10}};
  EXPECT_EQ(join_all(springs([](double spring, double) { return spring; }), row, box).size(), 30U);
  const ContactRows of_2_against_1 = springs([](double spring, double) { return -spring; });
  EXPECT_THROW(join_all(of_2_against_1, row, box), Error);
  EXPECT_THROW(join_all(springs([](double, double force) { return force; }), row, box), Error);
  // In fast motion dashpots turn f_t round in three of five contacts, and are stronger than the springs.
  ContactRows fast;
  for (int i = 0; i < 30; ++i) {
    const double spring = i % 2 == 0 ? 1e-3 : -1e-3;
    add_row(fast, {{id1, double(i + 1)},
                   {id2, double(i + 2)},
                   {fx, -10},
                   {fy, (i % 5 < 3 ? 240 : -80) * spring},
                   {xi, spring}});
  }
  EXPECT_EQ(join_all(fast, row, box).size(), 30U);
  ContactRules in_passing;
  in_passing.closely = false;
  EXPECT_EQ(join_all(of_2_against_1, row, box, in_passing).size(), 30U);
}

TEST(JoinContacts, ADiscAtAWallIsWhereTheRowSays) {
  const std::vector<Value> right = {{id1, 900}, {id2, -1}, {x1, 1}, {y1, 1},       {x2, 0.7},
                                    {y2, 1},    {nx, -1},  {ny, 0}, {overlap, 0.2}};
  EXPECT_EQ(refusal(right), "");
  for (const auto& [index, value] : {std::pair{2U, 1.1}, {4U, 0.8}, {6U, 1.0}, {8U, 0.3}}) {
    auto wrong = right;
    wrong[index].value = value;
    EXPECT_NE(refusal(wrong), "") << index;
  }
}

// A disc in the corner of a mesh touches two of its sides.
TEST(JoinContacts, ADiscMayTouchAMeshAtSeveralSides) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, first_mesh}, {x1, 1}, {y1, 1}, {x2, 0.7}, {y2, 1}});
  add_row(rows, {{id1, 900}, {id2, first_mesh}, {x1, 1}, {y1, 1}, {x2, 1}, {y2, 0.7}});
  EXPECT_EQ(join_all(rows, two_discs(), box_of_ten(false)).size(), 2U);
  rows.rows[1] = rows.rows[0];
  EXPECT_THROW(join_all(rows, two_discs(), box_of_ten(false)), Error);
}

TEST(JoinContacts, WallContactsGoToTheContactPoint) {
  // The wall touches disc 900 at distance 0.3 to its left: overlap 0.5 - 0.3.
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, -1}, {x1, 1}, {y1, 1}, {x2, 0.7}, {y2, 1}});
  const Contact contact = join_one(rows, two_discs(), box_of_ten(false));
  EXPECT_TRUE(contact.with_wall());
  EXPECT_DOUBLE_EQ(contact.normal[0], -1);
  EXPECT_NEAR(contact.overlap, 0.2, 1e-15);  // 1 - 0.7 is rounded
  EXPECT_EQ(contact.index2, -1);
}

TEST(JoinContacts, TheSamePairInBothOrdersIsListedTwice) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  add_row(rows, {{id1, 4}, {id2, 900}});
  EXPECT_THROW(join_all(rows, two_discs(), box_of_ten(false)), Error);
  EXPECT_THROW(join_all(rows, two_discs(), box_of_ten(true)), Error);
}

}  // namespace
}  // namespace mikromakro
