// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/frames/frame_selection.h"

#include <gtest/gtest.h>

#include <vector>

#include "model/error.h"

namespace mikromakro {
namespace {

// The indices of 7 frames that --frames selects.
std::vector<std::int64_t> selected(const std::string& text) {
  FrameSelection selection;
  select_frames(text, selection);
  selection = selection.among(7);
  std::vector<std::int64_t> indices;
  for (std::int64_t i = 0; i < 7; ++i)
    if (selection.contains(i, 100 * i)) indices.push_back(i);
  return indices;
}

TEST(FrameSelection, CountsFromBothEnds) {
  using Indices = std::vector<std::int64_t>;
  EXPECT_EQ(selected("2:4"), (Indices{2, 3, 4}));
  EXPECT_EQ(selected("3"), (Indices{3}));
  EXPECT_EQ(selected("-1"), (Indices{6}));
  EXPECT_EQ(selected("-1:"), (Indices{6}));
  EXPECT_EQ(selected("-3:"), (Indices{4, 5, 6}));
  EXPECT_EQ(selected(":-6"), (Indices{0, 1}));
  EXPECT_EQ(selected("-5:-2:2"), (Indices{2, 4}));
  EXPECT_EQ(selected("1:-5"), (Indices{1, 2}));
  EXPECT_EQ(selected("-99:1"), (Indices{0, 1}));
  EXPECT_EQ(selected("-8"), (Indices{}));
  EXPECT_EQ(selected("7"), (Indices{}));
  EXPECT_EQ(selected("5:-4"), (Indices{}));
}

TEST(FrameSelection, OtherTextsAreRefused) {
  for (const auto* text : {"", "a", "1:2:3:4", "4:2", "-2:-4", "1:2:0", "1.5"}) {
    FrameSelection selection;
    EXPECT_THROW(select_frames(text, selection), Error) << text;
  }
}

TEST(FrameSelection, OneStepOrARangeOfSteps) {
  FrameSelection selection;
  select_steps("300", selection);
  EXPECT_TRUE(selection.contains(0, 300));
  EXPECT_FALSE(selection.contains(1, 301));
  for (const auto* text : {"", "-1:", "1:2:3", "4:2"})
    EXPECT_THROW(select_steps(text, selection), Error) << text;
}

}  // namespace
}  // namespace mikromakro
