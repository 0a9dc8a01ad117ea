// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/repeated_frames.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

FrameSums frame(std::int64_t run, std::int64_t step, double first, double second) {
  FrameSums sums;
  sums.run = run;
  sums.step = step;
  sums.sums = Rows::Zero(2, 4);
  sums.sums << first, 1, 2 * first, 1, second, 1, 2 * second, 1;
  return sums;
}

TEST(RepeatedFrames, AreKnownByTheirSumsWithinTheDigitsOfADump) {
  RepeatedFrames frames;
  EXPECT_FALSE(frames.add(frame(0, 100, 3, 5)));
  EXPECT_FALSE(frames.add(frame(0, 200, 4, 6)));
  EXPECT_TRUE(frames.add(frame(1, 200, 4.00001, 6)));  // a part of the run, printed with six digits
  EXPECT_FALSE(frames.add(frame(1, 300, 4, 6)));       // another step
  EXPECT_FALSE(frames.add(frame(2, 100, 3.01, 5)));    // another packing
  EXPECT_FALSE(frames.add(frame(2, 200, 6, 4)));       // the same total elsewhere
}

// Steps that are counted from elsewhere; sums of equal discs by their centres agree by chance.
TEST(RepeatedFrames, AreKnownByThePlacesOfTheirDiscs) {
  RepeatedFrames frames;
  const auto add = [&](std::int64_t run, std::int64_t step, double places) {
    FrameSums one = frame(run, step, 3, 5 + static_cast<double>(step % 300));
    one.places = places;
    return frames.add(one);
  };
  EXPECT_FALSE(add(0, 100, 0.1));
  EXPECT_FALSE(add(0, 200, 0.2));
  EXPECT_FALSE(add(1, 400, 0.1));  // both runs may begin from the same state
  EXPECT_TRUE(add(1, 500, 0.2));
  EXPECT_FALSE(add(2, 700, 0.3));
  EXPECT_FALSE(add(2, 800, 0.4));
}

// Velocities alone are three sums: two that move and agree to all digits, which numbers of discs do by
// chance.
TEST(RepeatedFrames, AreKnownByTwoSumsToAllDigits) {
  for (const bool whole : {false, true}) {
    for (const double digits : {0.0, 1e-6}) {
      RepeatedFrames frames;
      for (const std::int64_t run : {0, 1}) {
        for (const std::int64_t step : {100, 200}) {
          const double change =
              static_cast<double>(step) / (whole ? 100 : 700) + digits * static_cast<double>(run);
          FrameSums two = frame(run, step, 3 + change, 5 + change);
          two.sums.col(1).setZero();
          EXPECT_EQ(frames.add(two), !whole && digits == 0 && run == 1 && step == 200);
        }
      }
    }
  }
}

// Two packings of the same discs have the same solid fraction where a volume holds all of them.
TEST(RepeatedFrames, AreNotKnownByFewSums) {
  RepeatedFrames frames;
  for (const std::int64_t run : {0, 1}) {
    FrameSums three = frame(run, 100, 3, 5);
    three.sums.col(3).setZero();
    EXPECT_FALSE(frames.add(three));
  }
}

TEST(RepeatedFrames, AreNoneWhereNothingMovesOrNothingIs) {
  RepeatedFrames frames;
  for (const std::int64_t run : {0, 1}) {
    EXPECT_FALSE(frames.add(frame(run, 100, 3 + 0.1 * static_cast<double>(run), 5)));
    EXPECT_FALSE(frames.add(frame(run, 200, 3 + 0.1 * static_cast<double>(run), 5)));
  }
  RepeatedFrames rigid;
  EXPECT_FALSE(rigid.add(frame(0, 100, 3, 5)));
  EXPECT_FALSE(rigid.add(frame(0, 200, 3, 5)));
  EXPECT_TRUE(rigid.add(frame(1, 100, 3, 5)));  // one packing at the start of both
  EXPECT_FALSE(rigid.add(frame(1, 200, 3, 5)));
  RepeatedFrames empty;
  for (const std::int64_t run : {0, 1}) {
    FrameSums nothing = frame(run, 100, 0, 0);
    nothing.sums.setZero();
    EXPECT_FALSE(empty.add(nothing));
  }
}

}  // namespace
}  // namespace mikromakro
