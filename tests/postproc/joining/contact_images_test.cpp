// SPDX-License-Identifier: GPL-2.0-or-later
// Which image of a disc a row is of.
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
  for (const double flag : {0.0, 1.0}) {
    ContactRows rows;
    add_row(rows, {{id1, 1}, {id2, 2}, {x1, 1}, {y1, 5}, {x2, 5.5}, {y2, 5}, {periodic, flag}});
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
    const Contact contact = join_one(rows, two_discs(), box_of_ten(box_is_periodic));
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
  EXPECT_EQ(refusal(images, two_discs(), true), "");
  EXPECT_NE(refusal(images, two_discs(), false), "");
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

TEST(JoinContacts, PeriodicIsAFlagOfAPeriodicBox) {
  // Across the box, which has no boundary that could bring them together.
  const std::vector<Particle> apart = {disc(900, 9.5, 5, 0.5), disc(4, 0.25, 5, 0.5)};
  const std::vector<Value> row = {{id1, 900}, {id2, 4}, {x1, 9.5},    {y1, 5},
                                  {x2, 0.25}, {y2, 5},  {periodic, 1}};
  EXPECT_NE(refusal(row, apart).find("a periodic box in the dump of particles"), std::string::npos);
  EXPECT_EQ(refusal(row, apart, true), "");
  EXPECT_NE(refusal({{id1, 900}, {id2, 4}, {periodic, 2}}, two_discs(), true).find("0 or 1"),
            std::string::npos);
}

TEST(JoinContacts, APairMayTouchThroughTwoImagesOfASmallBox) {
  const std::vector<Particle> discs = {disc(1, 2, 5, 2.6), disc(2, 7, 5, 2.6)};
  ContactRows rows;
  add_row(rows, {{id1, 1}, {id2, 2}, {nx, 1}, {ny, 0}, {overlap, 0.2}});
  add_row(rows, {{id1, 2}, {id2, 1}, {nx, 1}, {ny, 0}, {overlap, 0.2}});  // disc 1's image is right of disc 2
  EXPECT_EQ(join_all(rows, discs, box_of_ten(true)).size(), 2U);
  EXPECT_THROW(join_all(rows, discs, box_of_ten(false)), Error);
}

// The places of a disc that touches its own image do not say on which side; a force along x would have either
// sign.
TEST(JoinContacts, PlacesOfOneDiscDoNotSayOnWhichSideItsImageTouches) {
  const std::vector<Particle> one = {disc(1, 5, 5, 5.1)};
  const std::vector<Value> flagged = {{id1, 1}, {id2, 1}, {x1, 5}, {y1, 5}, {x2, 5}, {y2, 5}, {periodic, 1}};
  const std::vector<Value> with_overlap = {{id1, 1}, {id2, 1}, {x1, 5},       {y1, 5},
                                           {x2, 5},  {y2, 5},  {periodic, 1}, {overlap, 0.2}};
  for (const auto& row : {flagged, with_overlap}) {
    ContactRows rows;
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

}  // namespace
}  // namespace mikromakro
