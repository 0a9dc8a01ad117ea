// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/slow_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measured_error.h"
#include "statistics/error_trials.h"
#include "statistics/f_distribution.h"

namespace mikromakro {
namespace {

std::vector<std::int64_t> one_run(Eigen::Index frames) {
  return std::vector<std::int64_t>(static_cast<std::size_t>(frames), 0);
}

// The waves are orthogonal: 3 of the first and 1 of each of the next four have the ratio 9. For one series F
// of 1 and 4 degrees of freedom. A second run, of which 2 tau is a tenth and more, does not count.
TEST(SlowChange, IsTheSlowestWaveOverTheNext) {
  constexpr Eigen::Index frames = 50;
  Rows series = Rows::Zero(frames + 9, 1);
  for (Eigen::Index i = 0; i < frames; ++i)
    for (int k = 1; k <= 5; ++k)
      series(i, 0) +=
          (k == 1 ? 3 : 1) * std::cos(std::numbers::pi * k * (static_cast<double>(i) + 0.5) / frames);
  std::vector<std::int64_t> runs = one_run(frames + 9);
  for (Eigen::Index i = frames; i < frames + 9; ++i) runs[static_cast<std::size_t>(i)] = 1;
  CorrelationTime time;
  time.time = 1;
  const SlowChange change = slow_change(series, runs, time);
  expect_measured(change.ratio, 9, 1e-12);
  expect_measured(change.chance, f_tail(9, 1, 4), 1e-12);
  time.time = 6;
  EXPECT_TRUE(std::isnan(slow_change(series, runs, time).ratio));
}

// 300 fields of twenty series of ten 2 tau, in which nothing is slower: 1 % by chance, and as much again
// because waves that short are not quite equal; of 300, below 4 %. With a slow part, most.
TEST(SlowChange, ShowsWhatIsSlowerThanTheRun) {
  struct Case {
    double rho, slow;
    int frames;
  };
  std::mt19937_64 random(5);
  for (const Case& one : {Case{0, 0, 41}, Case{0.9, 0, 200}, Case{0, 0.3, 100}, Case{0, 0.3, 200}}) {
    int shows = 0;
    constexpr int trials = 300;
    for (int trial = 0; trial < trials; ++trial) {
      Rows series(one.frames, 20);
      const auto fast = CorrelatedNoise(one.rho, 1, 20)(one.frames, random);
      const auto slow = CorrelatedNoise(0.98, 1, 20)(one.frames, random);
      for (int i = 0; i < one.frames; ++i)
        series.row(i) = std::sqrt(1 - one.slow) * fast[static_cast<std::size_t>(i)].row(0) +
                        std::sqrt(one.slow) * slow[static_cast<std::size_t>(i)].row(0);
      const auto runs = one_run(one.frames);
      shows += slow_change(series, runs, correlation_time(series, runs)).shows() ? 1 : 0;
    }
    if (one.slow == 0) {
      EXPECT_LT(shows, 0.04 * trials) << one.frames;
    } else {
      EXPECT_GT(shows, 0.4 * trials) << one.frames;
    }
  }
}

}  // namespace
}  // namespace mikromakro
