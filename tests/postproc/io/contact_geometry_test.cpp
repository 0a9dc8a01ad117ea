#include "io/contact_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/error.h"

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

Contact join_one(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box) {
  return join_contacts(rows, particles, IdMap(particles), box).at(0);
}

TEST(JoinContacts, DerivesNormalAndOverlapFromTheDiscs) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  const Contact contact = join_one(rows, two_discs, box_of_ten(false));
  EXPECT_DOUBLE_EQ(contact.normal[0], 0.6);
  EXPECT_DOUBLE_EQ(contact.normal[1], 0.8);
  EXPECT_DOUBLE_EQ(contact.overlap, 0.25);
}

TEST(JoinContacts, TakesPositionsOfTheRowBeforeThoseOfTheDiscs) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}, {x1, 0}, {y1, 0}, {x2, -1}, {y2, 0}});
  const Contact contact = join_one(rows, two_discs, box_of_ten(false));
  EXPECT_DOUBLE_EQ(contact.normal[0], -1);
  EXPECT_DOUBLE_EQ(contact.overlap, 0.5);
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

TEST(JoinContacts, StockRowsMarkedPeriodicHaveWrappedPositions) {
  const std::vector<Particle> discs = {disc(1, 9.5, 5, 0.5), disc(2, 0.25, 5, 0.5)};
  for (const double flag : {0.0, 1.0}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 2}, {x1, 9.5}, {y1, 5}, {x2, 0.25}, {y2, 5}, {periodic, flag}});
    // Without the flag the positions are meant as they stand: 9.25 apart, normal backwards.
    EXPECT_DOUBLE_EQ(join_one(rows, discs, box_of_ten(true)).normal[0], flag == 1 ? 1 : -1);
  }
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
  EXPECT_EQ(join_contacts(rows, discs, IdMap(discs), box_of_ten(true)).size(), 2U);
  EXPECT_THROW(join_contacts(rows, discs, IdMap(discs), box_of_ten(false)), Error);
}

TEST(JoinContacts, TheSamePairInBothOrdersIsListedTwice) {
  ContactRows rows;
  add_row(rows, {{id1, 900}, {id2, 4}});
  add_row(rows, {{id1, 4}, {id2, 900}});
  EXPECT_THROW(join_contacts(rows, two_discs, IdMap(two_discs), box_of_ten(false)), Error);
  EXPECT_THROW(join_contacts(rows, two_discs, IdMap(two_discs), box_of_ten(true)), Error);
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

}  // namespace
}  // namespace mikromakro
