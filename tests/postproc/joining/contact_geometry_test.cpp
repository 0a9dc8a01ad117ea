// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "model/error.h"

namespace mikromakro {
namespace {

using enum ContactColumn;

struct Value {
  ContactColumn column;
  double value;
};

void add_row(ContactRows& rows, const std::vector<Value>& values) {
  ContactRow row;
  row.value.fill(std::nan(""));
  for (const Value& value : values) {
    row.value[static_cast<std::size_t>(value.column)] = value.value;
    rows.given |= column_bit(value.column);
  }
  rows.rows.push_back(row);
}

Particle disc(std::int64_t id, double x, double y, double radius) {
  Particle particle;
  particle.id = id;
  particle.position = {x, y};
  particle.radius = radius;
  return particle;
}

Box box_of_ten(bool periodic) {
  return {{0, 0}, {10, 10}, {periodic, false}};
}

// Discs 4 and 900: 0.5 + 1 - 1.25 = 0.25 overlap along (0.6, 0.8); all numbers are exact in binary or rounded
// once.
const std::vector<Particle> two_discs = {disc(900, 1, 1, 0.5), disc(4, 1.75, 2, 1)};

std::vector<Contact> join_all(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box,
                              const ContactRules& rules = {}) {
  const IdMap ids(particles);
  return join_contacts(rows, {particles, ids, box}, rules);
}

Contact join_one(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box) {
  return join_all(rows, particles, box).at(0);
}

// What join_contacts says to a row, empty where it takes it.
std::string refusal(const std::vector<Value>& row, const std::vector<Particle>& particles = two_discs,
                    bool periodic_box = false, bool distant = false) {
  ContactRows rows;
  rows.file = "c";
  rows.first_line = 10;
  add_row(rows, row);
  try {
    join_all(rows, particles, box_of_ten(periodic_box), {distant});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(JoinContacts, DerivesNormalAndOverlapFromTheDiscs) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  const Contact contact = join_one(rows, two_discs, box_of_ten(false));
  EXPECT_DOUBLE_EQ(contact.normal[0], 0.6);
  EXPECT_DOUBLE_EQ(contact.normal[1], 0.8);
  EXPECT_DOUBLE_EQ(contact.overlap, 0.25);
}

// x = 9.5 and x = 0.25 in a box of 10 are 0.75 apart across the boundary: n = (1, 0) from the first to the
// second.
TEST(JoinContacts, TakesTheNearestImageWhereTheBoxIsPeriodic) {
  const std::vector<Particle> discs = {disc(1, 9.5, 5, 0.5), disc(2, 0.25, 5, 0.5)};
  ContactRows rows;
  add_row(rows, {{id1, 1}, {id2, 2}});
  const Contact contact = join_one(rows, discs, box_of_ten(true));
  EXPECT_DOUBLE_EQ(contact.normal[0], 1);
  EXPECT_DOUBLE_EQ(contact.overlap, 0.25);
}

// Stock LIGGGHTS wraps the places of a row through the boundary: x = 9.5 and 0.25 as above. Without the flag
// they are meant as they stand: 9.25 apart, which is no contact; unless the row has a force or an overlap,
// since a disc that has left the box since the last neighbour list is wrapped in the rows, too.
TEST(JoinContacts, StockRowsMarkedPeriodicHaveWrappedPositions) {
  const std::vector<Particle> discs = {disc(1, 9.5, 5, 0.5), disc(2, 0.25, 5, 0.5)};
  for (const double flag : {0.0, 1.0}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 2}, {x1, 9.5}, {y1, 5}, {x2, 0.25}, {y2, 5}, {periodic, flag}});
    const auto contacts = join_all(rows, discs, box_of_ten(true));
    ASSERT_EQ(contacts.size(), flag == 1 ? 1U : 0U);
    if (flag == 1) {
      EXPECT_DOUBLE_EQ(contacts[0].normal[0], 1);
    }
  }
  for (const Value& touching : {Value{overlap, 0.25}, Value{fx, -1}}) {
    ContactRows rows;
    add_row(rows,
            {{id1, 1}, {id2, 2}, {x1, 9.5}, {y1, 5}, {x2, 0.25}, {y2, 5}, {periodic, 0}, {fy, 0}, touching});
    const auto contacts = join_all(rows, {disc(1, -0.5, 5, 0.5), disc(2, 0.25, 5, 0.5)}, box_of_ten(true));
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_DOUBLE_EQ(contacts[0].normal[0], 1);
    EXPECT_DOUBLE_EQ(contacts[0].overlap, 0.25);
  }
}

// Discs of radius 2.9 at 1 and 5.5 in a box of 10 touch directly, 4.5 apart, and through the boundary, 5.5
// apart: overlaps 1.3 and 0.3.
TEST(JoinContacts, InANarrowBoxTheRowSaysWhichImageTouches) {
  const std::vector<Particle> discs = {disc(1, 1, 5, 2.9), disc(2, 5.5, 5, 2.9)};
  const std::vector<Value> places = {{id1, 1}, {id2, 2}, {x1, 1}, {y1, 5}, {x2, 5.5}, {y2, 5}};
  for (const double flag : {0.0, 1.0}) {
    auto row = places;
    row.push_back({periodic, flag});
    ContactRows rows;
    add_row(rows, row);
    const Contact contact = join_one(rows, discs, box_of_ten(true));
    EXPECT_DOUBLE_EQ(contact.normal[0], flag == 1 ? -1 : 1);
    EXPECT_NEAR(contact.overlap, flag == 1 ? 0.3 : 1.3, 1e-15);
  }
  EXPECT_NE(refusal({{id1, 1}, {id2, 2}}, discs, true).find("touch through two images"), std::string::npos);
  EXPECT_EQ(refusal({{id1, 1}, {id2, 2}}, discs, false), "");
}

// Without the flag places in the box may be wrapped: the overlap or the normal tells, or nothing does. A
// place outside of the box is meant as it stands.
TEST(JoinContacts, InANarrowBoxPlacesAloneDoNotSayWhichImageTouches) {
  const std::vector<Particle> discs = {disc(1, 1, 5, 2.9), disc(2, 5.5, 5, 2.9)};
  const std::vector<Value> places = {{id1, 1}, {id2, 2}, {x1, 1}, {y1, 5}, {x2, 5.5}, {y2, 5}};
  const auto normal_of = [&](std::vector<Value> row, const std::vector<Value>& rest) {
    row.insert(row.end(), rest.begin(), rest.end());
    ContactRows rows;
    add_row(rows, row);
    return join_one(rows, discs, box_of_ten(true)).normal[0];
  };
  EXPECT_DOUBLE_EQ(normal_of(places, {{overlap, 0.3}}), -1);
  EXPECT_DOUBLE_EQ(normal_of(places, {{overlap, 1.3}}), 1);
  EXPECT_DOUBLE_EQ(normal_of(places, {{nx, -1}, {ny, 0}}), -1);
  EXPECT_DOUBLE_EQ(normal_of(places, {{nx, 1}, {ny, 0}}), 1);
  EXPECT_NE(refusal(places, discs, true).find("touch through two images"), std::string::npos);
  EXPECT_DOUBLE_EQ(normal_of({{id1, 1}, {id2, 2}, {x1, 1}, {y1, 5}, {x2, -4.5}, {y2, 5}}, {}), -1);
}

// Stock LIGGGHTS sets the flag across the border of two ranks, too.
TEST(JoinContacts, PeriodicRowsMayBeOfDiscsSideBySide) {
  for (const bool box_is_periodic : {false, true}) {
    ContactRows rows;
    add_row(rows, {{id1, 900}, {id2, 4}, {x1, 1}, {y1, 1}, {x2, 1.75}, {y2, 2}, {periodic, 1}});
    const Contact contact = join_one(rows, two_discs, box_of_ten(box_is_periodic));
    EXPECT_DOUBLE_EQ(contact.normal[0], 0.6);
    EXPECT_DOUBLE_EQ(contact.overlap, 0.25);
  }
  // Both touch in the narrow box: the overlap tells.
  const std::vector<Particle> discs = {disc(1, 1, 5, 2.9), disc(2, 5.5, 5, 2.9)};
  for (const double told : {1.3, 0.3}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 2}, {x1, 1}, {y1, 5}, {x2, 5.5}, {y2, 5}, {periodic, 1}, {overlap, told}});
    EXPECT_DOUBLE_EQ(join_one(rows, discs, box_of_ten(true)).normal[0], told == 0.3 ? -1 : 1);
  }
}

TEST(JoinContacts, PlacesOfARowAreThoseOfItsDiscsOrTheirImages) {
  const std::vector<Value> right = {{id1, 900}, {id2, 4}, {x1, 1}, {y1, 1}, {x2, 1.75}, {y2, 2}};
  EXPECT_EQ(refusal(right), "");
  auto images = right;
  images[2].value = 11;
  images[4].value = 11.75;
  EXPECT_EQ(refusal(images, two_discs, true), "");
  EXPECT_NE(refusal(images, two_discs, false), "");
  for (const std::size_t place : {2U, 3U, 4U, 5U}) {
    auto moved = right;
    moved[place].value += 1e-4;  // six digits of 2 are 5e-6
    EXPECT_NE(refusal(moved).find("c:10: disc " + std::to_string(place < 4 ? 900 : 4) +
                                  " is not where the row says"),
              std::string::npos)
        << refusal(moved);
    moved[place].value += 1e-6 - 1e-4;
    EXPECT_EQ(refusal(moved), "") << place;
  }
}

// One disc displaced by a fifth of the smaller radius in one of the two dumps, along the contact and across
// it.
TEST(JoinContacts, SeesADiscThatIsElsewhereInOneOfTheDumps) {
  const std::vector<Value> geometry = {{id1, 900}, {id2, 4}, {nx, 0.6}, {ny, 0.8}, {overlap, 0.25}};
  EXPECT_EQ(refusal(geometry), "");
  for (const Eigen::Vector2d& shift : {Eigen::Vector2d(0.06, 0.08), Eigen::Vector2d(-0.08, 0.06)}) {
    auto discs = two_discs;
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
  EXPECT_NEAR(join_one(rows, two_discs, box_of_ten(false)).overlap, 0.249999, 1e-15);
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
  EXPECT_EQ(join_all(touching, two_discs, box_of_ten(false)).size(), 1U);
}

TEST(JoinContacts, PeriodicIsAFlagOfAPeriodicBox) {
  // Across the box, which has no boundary that could bring them together.
  const std::vector<Particle> apart = {disc(900, 9.5, 5, 0.5), disc(4, 0.25, 5, 0.5)};
  const std::vector<Value> row = {{id1, 900}, {id2, 4}, {x1, 9.5},    {y1, 5},
                                  {x2, 0.25}, {y2, 5},  {periodic, 1}};
  EXPECT_NE(refusal(row, apart).find("a periodic box in the dump of particles"), std::string::npos);
  EXPECT_EQ(refusal(row, apart, true), "");
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {periodic, 2}}, two_discs, true).find("0 or 1"),
            std::string::npos);
}

// n = (0.6, 0.8), t = (-0.8, 0.6): f = -10 n + 1 t; shear = 3e-6 t.
TEST(JoinContacts, TakesForceAndSpringFromWhatIsGiven) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}, {fn, 10}, {ft, 1}, {shearx, -2.4e-6}, {sheary, 1.8e-6}});
  const Contact contact = join_one(rows, two_discs, box_of_ten(false));
  EXPECT_NEAR(contact.force[0], -6.8, 1e-14);
  EXPECT_NEAR(contact.force[1], -7.4, 1e-14);
  EXPECT_NEAR(contact.spring, 3e-6, 1e-20);
}

// In the columns of a spring: a normal force, along n.
TEST(JoinContacts, AForceAlongTheNormalIsNoSpring) {
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {fn, 10}, {ft, 1}, {shearx, -6}, {sheary, -8}}).find("no spring"),
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
  EXPECT_EQ(join_all(rows, two_discs, box_of_ten(false)).size(), 2U);
  rows.rows[1] = rows.rows[0];
  EXPECT_THROW(join_all(rows, two_discs, box_of_ten(false)), Error);
}

TEST(JoinContacts, WallContactsGoToTheContactPoint) {
  // The wall touches disc 900 at distance 0.3 to its left: overlap 0.5 - 0.3.
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, -1}, {x1, 1}, {y1, 1}, {x2, 0.7}, {y2, 1}});
  const Contact contact = join_one(rows, two_discs, box_of_ten(false));
  EXPECT_TRUE(contact.with_wall());
  EXPECT_DOUBLE_EQ(contact.normal[0], -1);
  EXPECT_NEAR(contact.overlap, 0.2, 1e-15);  // 1 - 0.7 is rounded
  EXPECT_EQ(contact.index2, -1);
}

TEST(JoinContacts, APairMayTouchThroughTwoImagesOfASmallBox) {
  const std::vector<Particle> discs = {disc(1, 2, 5, 2.6), disc(2, 7, 5, 2.6)};
  ContactRows rows;
  add_row(rows, {{id1, 1}, {id2, 2}, {nx, 1}, {ny, 0}, {overlap, 0.2}});
  add_row(rows, {{id1, 2}, {id2, 1}, {nx, 1}, {ny, 0}, {overlap, 0.2}});  // disc 1's image is right of disc 2
  EXPECT_EQ(join_all(rows, discs, box_of_ten(true)).size(), 2U);
  EXPECT_THROW(join_all(rows, discs, box_of_ten(false)), Error);
}

TEST(JoinContacts, TheSamePairInBothOrdersIsListedTwice) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  add_row(rows, {{id1, 4}, {id2, 900}});
  EXPECT_THROW(join_all(rows, two_discs, box_of_ten(false)), Error);
  EXPECT_THROW(join_all(rows, two_discs, box_of_ten(true)), Error);
}

// Six digits give 9.999 and 10.0024 for two discs of radius 0.003 across a boundary, but 0.002449 and -0.001
// in the opposite order: normals that differ by 0.007 are still those of one contact.
TEST(JoinContacts, PlacesOfFewDigitsDoNotMakeTwoContactsOfOnePair) {
  const std::vector<Particle> discs = {disc(1, 9.999, 3.5, 0.003), disc(2, 0.002449, 3.5035, 0.003)};
  ContactRows rows;
  add_row(rows, {{id1, 1}, {id2, 2}, {x1, 9.999}, {y1, 3.5}, {x2, 10.0024}, {y2, 3.5035}});
  EXPECT_EQ(join_all(rows, discs, box_of_ten(true)).size(), 1U);
  add_row(rows, {{id1, 2}, {id2, 1}, {x1, 0.002449}, {y1, 3.5035}, {x2, -0.001}, {y2, 3.5}});
  EXPECT_THROW(join_all(rows, discs, box_of_ten(true)), Error);
}

// The places of a disc that touches its own image do not say on which side; a force along x would have either
// sign.
TEST(JoinContacts, PlacesOfOneDiscDoNotSayOnWhichSideItsImageTouches) {
  const std::vector<Particle> one = {disc(1, 5, 5, 5.1)};
  const std::vector<Value> flagged = {{id1, 1}, {id2, 1}, {x1, 5}, {y1, 5}, {x2, 5}, {y2, 5}, {periodic, 1}};
  for (const bool with_overlap : {false, true}) {
    ContactRows rows;
    auto row = flagged;
    if (with_overlap) row.push_back({overlap, 0.2});
    add_row(rows, row);
    EXPECT_THROW(join_all(rows, one, box_of_ten(true)), Error);
  }
  for (const double side : {1.0, -1.0}) {
    ContactRows rows;
    auto row = flagged;
    row.insert(row.end(), {{nx, side}, {ny, 0}, {overlap, 0.2}});
    add_row(rows, row);
    EXPECT_EQ(join_one(rows, one, box_of_ten(true)).normal[0], side);
  }
}

// Discs 9 apart along y in a box that is periodic along both axes, 10 wide: the images at (0, -1) and
// (+-10, -1) touch; the overlap is that of the first or of the others.
TEST(JoinContacts, TheOverlapTellsWhichOfSeveralImagesTouches) {
  const Box box{{0, 0}, {4, 10}, {true, true}};
  const std::vector<Particle> discs = {disc(1, 1, 0.5, 2), disc(2, 2.5, 9.5, 2)};
  const auto rows_with = [](double told) {
    ContactRows rows;
    add_row(rows,
            {{id1, 1}, {id2, 2}, {x1, 1}, {y1, 0.5}, {x2, 2.5}, {y2, 9.5}, {periodic, 1}, {overlap, told}});
    return rows;
  };
  const auto overlap_at = [](double x, double y) { return 4 - std::hypot(x, y); };
  EXPECT_NEAR(join_one(rows_with(overlap_at(1.5, -1)), discs, box).normal[0], 1.5 / std::hypot(1.5, 1),
              1e-12);
  EXPECT_NEAR(join_one(rows_with(overlap_at(-2.5, -1)), discs, box).normal[0], -2.5 / std::hypot(2.5, 1),
              1e-12);
}

TEST(IdMap, FindsIdsThatAreDenseOrFarApart) {
  for (const std::int64_t far : {std::int64_t{12}, std::int64_t{1} << 40}) {
    const std::vector<Particle> discs = {disc(far, 0, 0, 1), disc(5, 0, 0, 1), disc(7, 0, 0, 1)};
    const IdMap ids(discs);
    EXPECT_EQ(ids.find(far), 0);
    EXPECT_EQ(ids.find(5), 1);
    EXPECT_EQ(ids.find(6), -1);
    EXPECT_EQ(ids.find(1), -1);
    EXPECT_EQ(ids.find(far + 1), -1);
    EXPECT_EQ(ids.duplicate(), -1);
    EXPECT_EQ(IdMap({disc(far, 0, 0, 1), disc(5, 0, 0, 1), disc(5, 0, 0, 1)}).duplicate(), 2);
  }
}

// A disc of radius 6 in a box of 10 touches itself: one contact, from whichever side it is seen.
TEST(JoinContacts, ADiscTouchesItsImageOnce) {
  const std::vector<Particle> one = {disc(1, 5, 5, 6)};
  for (const double side : {1.0, -1.0}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 1}, {nx, side}, {ny, 0}, {overlap, 2}});
    EXPECT_EQ(join_all(rows, one, box_of_ten(true)).size(), 1U);
    add_row(rows, {{id1, 1}, {id2, 1}, {nx, -1}, {ny, 0}, {overlap, 2}});
    EXPECT_THROW(join_all(rows, one, box_of_ten(true)), Error);
  }
}

// The same along y, where nx is rounding of any sign.
TEST(JoinContacts, ADiscTouchesItsImageOnceThoughNormalsAreRounded) {
  const std::vector<Particle> one = {disc(1, 5, 5, 6)};
  Box box = box_of_ten(true);
  box.periodic = {true, true};
  for (const double rounding : {1e-9, -1e-9, 0.0}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 1}, {nx, 1e-9}, {ny, 1}, {overlap, 2}});
    add_row(rows, {{id1, 1}, {id2, 1}, {nx, 1}, {ny, 1e-9}, {overlap, 2}});
    EXPECT_EQ(join_all(rows, one, box).size(), 2U);
    add_row(rows, {{id1, 1}, {id2, 1}, {nx, rounding}, {ny, -1}, {overlap, 2}});
    EXPECT_THROW(join_all(rows, one, box), Error) << rounding;
  }
}

}  // namespace
}  // namespace mikromakro
