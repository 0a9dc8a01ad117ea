// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/plausible_forces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro {
namespace {

// Contacts in all directions whose forces push by 1 and act along the tangent by +-0.4.
std::vector<Contact> contacts(int count) {
  std::vector<Contact> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Contact& contact = all[static_cast<std::size_t>(i)];
    contact.id1 = 1;
    contact.id2 = 2;
    contact.normal = {std::cos(2.4 * i), std::sin(2.4 * i)};
    const Eigen::Vector2d tangent(-contact.normal.y(), contact.normal.x());
    contact.force = -contact.normal + (i % 2 == 0 ? 0.4 : -0.4) * tangent;
  }
  return all;
}

std::vector<std::string> notes_of(const std::vector<Contact>& contacts) {
  Notes notes;
  note_forces(contacts, {false, &notes, 5, {}});
  return notes.lines();
}

TEST(PlausibleForces, PushWithFriction) {
  EXPECT_TRUE(notes_of(contacts(30)).empty());
  EXPECT_TRUE(notes_of({}).empty());
}

TEST(PlausibleForces, DoNotPullAndAreNotAcross) {
  auto pulling = contacts(30), exchanged = pulling;
  for (Contact& contact : pulling) contact.force = -contact.force;
  for (Contact& contact : exchanged) contact.force = contact.force.reverse().eval();
  for (const auto& wrong : {pulling, exchanged}) {
    ASSERT_EQ(notes_of(wrong).size(), 1U);
    EXPECT_NE(notes_of(wrong)[0].find("contacts are attractive on average"), std::string::npos);
  }
  exchanged.resize(10);
  pulling.resize(10);
  EXPECT_TRUE(notes_of(exchanged).empty());
  EXPECT_EQ(notes_of(pulling).size(), 1U);
  pulling.resize(4);  // these may
  EXPECT_TRUE(notes_of(pulling).empty());
}

TEST(PlausibleForces, OfWallsAreJudgedAlone) {
  auto pairs_and_walls = contacts(60);
  for (std::size_t i = 0; i < 8; ++i) pairs_and_walls[i].id2 = -1;
  const auto notes_of_walls = [&] {
    Notes notes;
    note_wall_forces(pairs_and_walls, {false, &notes, 5, {}});
    return notes.lines();
  };
  EXPECT_TRUE(notes_of_walls().empty());
  for (std::size_t i = 0; i < 8; ++i) pairs_and_walls[i].force *= -1;
  ASSERT_EQ(notes_of_walls().size(), 1U);
  EXPECT_NE(notes_of_walls()[0].find("walls are attractive on average"), std::string::npos);
  EXPECT_TRUE(notes_of(pairs_and_walls).empty());
  // Nor do walls that push hide pairs that pull.
  for (Contact& contact : pairs_and_walls) contact.force *= contact.with_wall() ? -50 : -1;
  EXPECT_TRUE(notes_of_walls().empty());
  EXPECT_EQ(notes_of(pairs_and_walls).size(), 1U);
  // Forces of walls in mN, and none.
  for (Contact& contact : pairs_and_walls) contact.force *= contact.with_wall() ? 1000 : -50;
  ASSERT_EQ(notes_of_walls().size(), 1U);
  EXPECT_NE(notes_of_walls()[0].find("hundreds of times those of pairs"), std::string::npos);
  for (Contact& contact : pairs_and_walls)
    if (contact.with_wall()) contact.force.setZero();
  ASSERT_EQ(notes_of_walls().size(), 1U);
  EXPECT_NE(notes_of_walls()[0].find("all forces of walls are 0"), std::string::npos);
}

// In a gas a few collisions carry nearly all of the force, and the contacts that are looked at may just be
// parting.
TEST(PlausibleForces, OfSomeContactsAreNotThoseOfAll) {
  auto gas = contacts(640);
  for (std::size_t i = 0; i < gas.size(); i += 10) gas[i].force *= -1;
  EXPECT_TRUE(notes_of(gas).empty());
}

TEST(PlausibleForces, AreNotAllZero) {
  auto zero = contacts(3);
  for (Contact& contact : zero) contact.force.setZero();
  ASSERT_EQ(notes_of(zero).size(), 1U);
  EXPECT_NE(notes_of(zero)[0].find("all forces are 0"), std::string::npos);
  zero[1].force = {1e-30, 0};
  EXPECT_TRUE(notes_of(zero).empty());
  for (Contact& contact : zero) contact.force = {not_given, not_given};
  EXPECT_TRUE(notes_of(zero).empty());
}

}  // namespace
}  // namespace mikromakro
