// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/notes.h"

#include <gtest/gtest.h>

#include <thread>

namespace mikromakro {
namespace {

TEST(Notes, EachTextIsTheLineOfAllItsFrames) {
  Notes notes;
  EXPECT_TRUE(notes.lines().empty());
  notes.add("late", 900);
  notes.add("rows", 800, 3);
  notes.add("rows", 1000, 4);
  notes.add("frames", 850);
  notes.add("frames", 950);
  notes.add("many", 860, 2);
  notes.add("of all");
  const std::vector<std::string> expected = {"of all", "rows (7 times in 2 frames, first step 800)",
                                             "frames (2 frames, first step 850)",
                                             "many (2 times in step 860)", "late (step 900)"};
  EXPECT_EQ(notes.lines(), expected);
}

TEST(Notes, FramesThatAreReadTwiceCountOnce) {
  Notes one;
  one.add("a b", 800, 3);
  one.add("a b", 800, 3);
  Notes other;
  other.add("a b", 800, 3);
  other.add("a b", 900);
  other.add("of all");
  one.add(other);
  one.add(one);
  const std::vector<std::string> expected = {"of all", "a b (4 times in 2 frames, first step 800)"};
  EXPECT_EQ(one.lines(), expected);
}

TEST(Notes, AnyThreadMayAdd) {
  Notes notes;
  std::vector<std::jthread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&notes, i] {
      for (std::int64_t step = 0; step < 1000; ++step) notes.add("rows", 4 * step + i, 2);
    });
  threads.clear();
  EXPECT_EQ(notes.lines(), std::vector<std::string>{"rows (8000 times in 4000 frames, first step 0)"});
}

}  // namespace
}  // namespace mikromakro
