// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mikromakro {
namespace {

// Frames of steps 10 i + 5 with random sums.
std::vector<FrameSums> frames_of(std::int64_t count, std::int64_t run = 0) {
  std::mt19937 random(static_cast<unsigned>(17 + run));
  std::uniform_real_distribution<double> between(0.1, 1);
  std::vector<FrameSums> frames;
  for (std::int64_t i = 0; i < count; ++i) {
    Rows sums(4, 3);
    for (double& sum : sums.reshaped()) sum = between(random);
    frames.push_back({i, 10 * i + 5, run, 0.5 * static_cast<double>(i), not_given,
                      Eigen::ArrayXd::Constant(2, 1.0 * static_cast<double>(i)), sums});
  }
  return frames;
}

struct Seen {
  Rows mean;
  std::int64_t run, first_step, last_step;
  double step, time, wall;
  std::size_t blocks;
};

std::vector<Seen> windows_of(const WindowRule& rule, const std::vector<FrameSums>& frames,
                             std::vector<Windows::Rest>* rests = nullptr) {
  std::vector<Seen> seen;
  Windows windows(rule, 64, [&](const Window& window) {
    seen.push_back({window.sums.mean(), window.run, window.first_step, window.last_step, window.step,
                    window.time, window.walls[1], window.sums.blocks().size()});
  });
  for (const FrameSums& frame : frames) windows.add(frame);
  windows.finish();
  EXPECT_EQ(windows.windows(), std::ssize(seen));
  if (rests != nullptr) *rests = windows.rests();
  return seen;
}

TEST(Windows, AddUpToTheWhole) {
  const std::vector<FrameSums> frames = frames_of(120);
  TimeAverage whole;
  for (const FrameSums& frame : frames) whole.add(frame.sums);
  Rows sum = Rows::Zero(4, 3);
  for (const Seen& window : windows_of({8, false}, frames)) sum += 8 * window.mean;
  constexpr double rounding = 1e-13;
  EXPECT_LE((sum / (120 * whole.mean()) - 1).abs().maxCoeff(), rounding);
}

// By hand: 0 1 2, 3 4 5; frame 6 is left out.
TEST(Windows, FollowOneAnother) {
  std::vector<Windows::Rest> rests;
  const std::vector<Seen> windows = windows_of({3, false}, frames_of(7), &rests);
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[1].first_step, 35);
  EXPECT_EQ(windows[1].last_step, 55);
  EXPECT_EQ(windows[1].step, 45);
  EXPECT_EQ(windows[1].time, 2);
  EXPECT_EQ(windows[1].wall, 4);
  EXPECT_EQ(windows[1].blocks, 3U);
  ASSERT_EQ(rests.size(), 1U);
  EXPECT_EQ(rests[0].frames, 1);
  EXPECT_EQ(rests[0].first_step, 65);
}

// 0 1 2, 1 2 3, ... each as if it were alone.
TEST(Windows, ThatMoveHaveTheBitsOfEachAlone) {
  const std::vector<FrameSums> frames = frames_of(9);
  std::vector<Windows::Rest> rests;
  const std::vector<Seen> moving = windows_of({4, true}, frames, &rests);
  ASSERT_EQ(moving.size(), 6U);
  EXPECT_TRUE(rests.empty());
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(i);
    const std::vector<Seen> alone = windows_of({4, false}, {begin, begin + 4});
    EXPECT_TRUE((moving[i].mean == alone.at(0).mean).all()) << i;
    EXPECT_EQ(moving[i].step, 10 * (static_cast<double>(i) + 1.5) + 5);
    EXPECT_EQ(moving[i].first_step, alone[0].first_step);
    EXPECT_EQ(moving[i].last_step, alone[0].last_step);
  }
}

// Runs of 5, 2 and 4 frames in windows of 3: the second run is too short for one.
TEST(Windows, HoldFramesOfOneRun) {
  for (const bool moving : {false, true}) {
    std::vector<FrameSums> frames = frames_of(5, 0);
    for (const std::vector<FrameSums>& more : {frames_of(2, 1), frames_of(4, 2)})
      frames.insert(frames.end(), more.begin(), more.end());
    std::vector<Windows::Rest> rests;
    const std::vector<Seen> windows = windows_of({3, moving}, frames, &rests);
    ASSERT_EQ(windows.size(), moving ? 5U : 2U);
    EXPECT_EQ(windows.front().run, 0);
    EXPECT_EQ(windows.back().run, 2);
    EXPECT_EQ(windows.back().first_step, moving ? 15 : 5);
    ASSERT_EQ(rests.size(), moving ? 1U : 3U);
    EXPECT_EQ(rests[moving ? 0 : 1].run, 1);
    EXPECT_EQ(rests[moving ? 0 : 1].frames, 2);
  }
}

TEST(Windows, TakeTimesFromTheTimeStepWhereFilesHaveNone) {
  std::vector<FrameSums> frames = frames_of(2);
  for (FrameSums& frame : frames) frame.time = std::nan("");
  EXPECT_TRUE(std::isnan(windows_of({2, false}, frames)[0].time));
  EXPECT_DOUBLE_EQ(windows_of({2, false, 0.1}, frames)[0].time, 0.1 * (5 + 15) / 2);
  EXPECT_DOUBLE_EQ(windows_of({2, false, 0.1}, frames_of(2))[0].time, 0.25);
}

}  // namespace
}  // namespace mikromakro
