// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/overlapping_discs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace mikromakro {
namespace {

Particle disc(int id, double x, double y, double radius, int type = 1) {
  Particle particle;
  particle.id = id;
  particle.type = type;
  particle.position = {x, y};
  particle.radius = radius;
  return particle;
}

using Pairs = std::set<std::pair<int, int>>;

Pairs all_with_all(const std::vector<Particle>& discs, const Box& box) {
  Pairs pairs;
  for (int i = 0; i < std::ssize(discs); ++i)
    for (int j = i + 1; j < std::ssize(discs); ++j) {
      const Particle &one = discs[static_cast<std::size_t>(i)], &two = discs[static_cast<std::size_t>(j)];
      Eigen::Vector2d branch = two.position - one.position;
      for (int axis = 0; axis < 2; ++axis)
        if (box.periodic[static_cast<std::size_t>(axis)])
          branch[axis] = std::remainder(branch[axis], box.length()[axis]);
      if (branch.norm() < one.radius + two.radius) pairs.emplace(i, j);
    }
  return pairs;
}

Pairs names_of(const std::vector<DiscPair>& found) {
  Pairs pairs;
  for (const DiscPair& pair : found) EXPECT_TRUE(pairs.emplace(pair.first, pair.second).second) << "twice";
  return pairs;
}

// Sizes over a factor of 100, some discs outside of the box, one lost far away.
TEST(OverlappingDiscs, AreThoseOfAllWithAll) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.1, 1.1), size(-2, 0);
  std::vector<Particle> discs = {disc(1000, 3e9, -2e9, 0.01)};
  for (int i = 0; i < 400; ++i)
    discs.push_back(disc(i, place(random), 2 * place(random), 0.1 * std::pow(10, size(random))));
  for (const bool along_x : {false, true})
    for (const bool along_y : {false, true}) {
      const Box box{{0, 0}, {1, 2}, {along_x, along_y}};
      const Pairs expected = all_with_all(discs, box);
      EXPECT_GT(expected.size(), 100U);
      EXPECT_EQ(names_of(overlapping_discs(discs, box)), expected);
    }
}

TEST(OverlappingDiscs, KnowHowFarTheyOverlap) {
  const Box box{{0, 0}, {10, 10}, {true, false}};
  const auto pairs = overlapping_discs({disc(1, 0.5, 5, 1), disc(2, 9, 5, 1), disc(3, 5, 5, 1)}, box);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_DOUBLE_EQ(pairs[0].overlap, 0.5);  // 1.5 apart through the boundary
}

TEST(OverlappingDiscs, MayBeNone) {
  EXPECT_TRUE(overlapping_discs({}, {}).empty());
  EXPECT_TRUE(overlapping_discs({disc(1, 0, 0, 1)}, {{0, 0}, {2, 3}, {true, true}}).empty());
}

// A box of 1.85 and 3: 0.95 apart directly, 0.9 through the boundary, and each disc touches its own image
// along x where its diameter is more than 1.85.
TEST(OverlappingDiscs, OfANarrowBoxTouchThroughSeveralImages) {
  const Box box{{0, 0}, {1.85, 3}, {true, true}};
  const auto both = overlapping_discs({disc(1, 0.4, 1, 0.5), disc(2, 1.35, 1, 0.5)}, box);
  ASSERT_EQ(both.size(), 2U);
  const auto direct = both[0].branch.x() > 0 ? 0U : 1U;
  EXPECT_NEAR(both[direct].branch.x(), 0.95, 1e-15);
  EXPECT_NEAR(both[1 - direct].branch.x(), -0.9, 1e-15);
  EXPECT_NEAR(both[1 - direct].overlap, 0.1, 1e-15);

  const auto own = overlapping_discs({disc(1, 0.4, 1, 1)}, box);
  ASSERT_EQ(own.size(), 1U);
  EXPECT_EQ(own[0].second, 0);
  EXPECT_NEAR(own[0].overlap, 0.15, 1e-15);
}

std::string notes_of(const std::vector<Particle>& discs, const std::vector<Contact>& contacts,
                     const std::vector<int>& types = {}, bool with_contacts = true,
                     const Box& box = {{0, 0}, {10, 10}}) {
  RawFrame raw;
  raw.step = 5;
  raw.box = box;
  raw.particles = discs;
  raw.with_contacts = with_contacts;
  Notes notes;
  note_overlaps(raw, contacts, {false, &notes, 5, types});
  std::string all;
  for (const std::string& line : notes.lines()) all += line + "\n";
  return all;
}

Contact contact_of(int first, int second, const Eigen::Vector2d& normal) {
  Contact contact;
  contact.id2 = second + 1;
  contact.normal = normal;
  contact.index1 = first;
  contact.index2 = second;
  return contact;
}

TEST(NoteOverlaps, TellsOfContactsThatAreNotThere) {
  const std::vector<Particle> discs = {disc(1, 1, 1, 0.5, 1), disc(2, 1.9, 1, 0.5, 2),
                                       disc(3, 1, 1.9, 0.5, 2), disc(4, 1.9, 1.9, 0.5, 2)};
  const std::vector<Contact> all = {contact_of(1, 0, {-1, 0}), contact_of(0, 2, {0, 1}),
                                    contact_of(1, 3, {0, 1}), contact_of(3, 2, {-1, 0})};
  EXPECT_EQ(notes_of(discs, all), "");
  const std::string without_two = notes_of(discs, {all[0], all[1]});
  EXPECT_NE(without_two.find("no contact row"), std::string::npos);
  EXPECT_NE(without_two.find("(2 times in step 5)"), std::string::npos) << without_two;
  // Discs of a wall may overlap each other: only disc 1 is averaged, and its contacts are there.
  EXPECT_EQ(notes_of(discs, {all[0], all[1]}, {1}), "");
  EXPECT_NE(notes_of(discs, {all[0]}, {1}), "");
  // Without any file of contacts none are missed.
  EXPECT_EQ(notes_of(discs, {}, {}, false), "");
}

// The box of OfANarrowBoxTouchThroughSeveralImages: a row for each image is due.
TEST(NoteOverlaps, OfANarrowBoxAreOneForEachImage) {
  const Box box{{0, 0}, {1.85, 3}, {true, false}};
  const std::vector<Particle> two = {disc(1, 0.4, 1, 0.5), disc(2, 1.35, 1, 0.5)};
  const auto notes = [&](const std::vector<Particle>& discs, const std::vector<Contact>& contacts) {
    return notes_of(discs, contacts, {}, true, box);
  };
  EXPECT_EQ(notes(two, {contact_of(0, 1, {1, 0}), contact_of(1, 0, {1, 0})}), "");
  EXPECT_NE(notes(two, {contact_of(0, 1, {1, 0})}).find("no contact row"), std::string::npos);
  EXPECT_NE(notes(two, {contact_of(1, 0, {1, 0})}).find("no contact row"), std::string::npos);

  const std::vector<Particle> one = {disc(1, 0.4, 1, 1)};
  EXPECT_EQ(notes(one, {contact_of(0, 0, {-1, 0})}), "");
  EXPECT_NE(notes(one, {}).find("no contact row"), std::string::npos);
}

// Six digits of coordinates up to 10 do not tell an overlap of 1e-6.
TEST(NoteOverlaps, LeavesOutWhatDigitsDoNotTell) {
  EXPECT_EQ(notes_of({disc(1, 1, 1, 0.5), disc(2, 1.999999, 1, 0.5)}, {}), "");
  EXPECT_NE(notes_of({disc(1, 1, 1, 0.5), disc(2, 1.99, 1, 0.5)}, {}), "");
}

TEST(NoteOverlaps, TellsOfDiscsOnOneAnother) {
  const std::vector<Particle> discs = {disc(1, 1, 1, 0.5), disc(2, 1.2, 1, 0.5), disc(3, 5, 5, 0.5),
                                       disc(4, 5.8, 5, 0.5)};
  const std::string text = notes_of(discs, {}, {}, false);
  EXPECT_NE(text.find("discs overlap by more than half a radius"), std::string::npos) << text;
  EXPECT_NE(text.find("(step 5)"), std::string::npos) << text;  // once: the others overlap by 0.2
}

}  // namespace
}  // namespace mikromakro
