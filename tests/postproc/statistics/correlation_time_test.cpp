// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/correlation_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "measured_error.h"
#include "statistics/error_decision.h"
#include "statistics/error_trials.h"
#include "statistics/lagged_products.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

std::vector<std::int64_t> one_run(Eigen::Index frames) {
  return std::vector<std::int64_t>(static_cast<std::size_t>(frames), 0);
}

// A row for each frame, a column for each of `count` independent series.
Rows noise(double rho, Eigen::Index count, int frames, std::mt19937_64& random) {
  Rows series(frames, count);
  Eigen::Index frame = 0;
  for (const Rows& row : CorrelatedNoise(rho, 1, count)(frames, random)) series.row(frame++) = row.row(0);
  return series;
}

// 1, 2, 3, 4: deviations -3/2, -1/2, 1/2, 3/2, variance 5/4; products at the lag 1 are 3/4, -1/4, 3/4, their
// mean over the variance 1/3; with a new run after the second frame the middle one falls out: 3/5. All pairs
// at most 1 apart, either way, over 4^2: (4 + 2 (3/4 - 1/4 + 3/4)/(5/4))/16 and (4 + 2 (3/4 + 3/4)/(5/4))/16.
TEST(LaggedProducts, AreMeansOverPairsOfTheSameRun) {
  Rows series(4, 1);
  series << 1, 2, 3, 4;
  LaggedProducts one(series, {0, 0, 0, 0});
  EXPECT_EQ(one.longest(), 1);
  EXPECT_FALSE(one.all_lags());
  EXPECT_EQ(one.pairs(1), 3);
  expect_measured(one.mean(0), 1, rounding);
  expect_measured(one.mean(1), 1.0 / 3, rounding);
  expect_measured(one.sums_of_series(1)[0], 6.0 / 16, rounding);
  LaggedProducts two(series, {0, 0, 1, 1});
  EXPECT_TRUE(two.all_lags());
  EXPECT_EQ(two.pairs(1), 2);
  expect_measured(two.mean(1), 0.6, rounding);
  expect_measured(two.sums_of_series(1)[0], 6.4 / 16, rounding);
}

// The sums of each series are those of its products lag by lag, however long the lag.
TEST(LaggedProducts, AddUpForEachSeries) {
  std::mt19937_64 random(1);
  const std::vector<std::int64_t> runs = {0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2};
  const Rows series = noise(0.5, 2, 20, random);
  for (Eigen::Index i = 0; i < 2; ++i) {
    LaggedProducts one(series.col(i), runs);
    double sum = one.pairs(0) * one.mean(0);
    for (Eigen::Index lag = 1; lag <= 10; ++lag) {
      sum += 2 * one.pairs(lag) * one.mean(lag);
      expect_measured(LaggedProducts(series, runs).sums_of_series(lag)[i], sum / 400, rounding);
    }
  }
}

// 0, 0, 0, 4: deviations -1, -1, -1, 3, variance 3, third moment 6: 6^2/3^3; and of -1, 0, 1, 0 none.
TEST(LaggedProducts, KnowTheSkewness) {
  Rows series(4, 2);
  series << 0, -1, 0, 0, 0, 1, 4, 0;
  expect_measured(LaggedProducts(series, one_run(4)).square_skewness(), 36.0 / 27 / 2, rounding);
}

// Twenty copies of a series, with either sign, tell as much as one; of twenty independent series of 1000
// frames r^2 = 1/1000 is chance and taken off; its scatter 1/1000 sqrt(2/190) gives 20 to 0.2 %: three times
// that.
TEST(LaggedProducts, CountIndependentSeries) {
  std::mt19937_64 random(1);
  const Rows series = noise(0, 20, 1000, random);
  Rows copies = series;
  for (Eigen::Index i = 0; i < 20; ++i) copies.col(i) = (i % 2 == 0 ? 3 : -1) * series.col(0);
  expect_measured(LaggedProducts(copies, one_run(1000)).independent_series(1), 1, rounding);
  EXPECT_NEAR(LaggedProducts(series, one_run(1000)).independent_series(1), 20, 0.12);
}

TEST(CorrelationTime, OfRunsOfOneFrameIsOne) {
  std::mt19937_64 random(1);
  std::vector<std::int64_t> runs(20);
  std::iota(runs.begin(), runs.end(), 0);
  const CorrelationTime time = correlation_time(noise(0.9, 5, 20, random), runs);
  EXPECT_EQ(time.most, 1);
  EXPECT_EQ(time.time, 1);
  expect_measured(time.uncertainty, 0, rounding);
}

struct Case {
  double rho;
  int frames;
};

class CorrelationTimes : public testing::TestWithParam<Case> {};

// Mean of 100 estimates, each of 20 series, against 2 tau = (1 + rho)/(1 - rho) less 2 rho (1 - rho^n)/n/(1 -
// rho)^2, as only lags up to n are there; the window ends at rho^(3 tau) = e^-3 of the sum or later, 5 %, and
// the mean of 100 has another 2 %. What each says of its uncertainty must be the scatter of the 100, which is
// known to 7 %: three times that, and the window itself scatters, up to 20 %.
TEST_P(CorrelationTimes, AndTheirUncertaintyAreRight) {
  const auto [rho, frames] = GetParam();
  std::mt19937_64 random(11);
  constexpr int estimates = 100;
  double sum = 0, squares = 0, said = 0;
  for (int i = 0; i < estimates; ++i) {
    const CorrelationTime time = correlation_time(noise(rho, 20, frames, random), one_run(frames));
    sum += time.time;
    squares += time.time * time.time;
    said += time.uncertainty;
  }
  const double mean = sum / estimates;
  const double expected =
      (1 + rho) / (1 - rho) - 2 * rho * (1 - std::pow(rho, frames)) / frames / std::pow(1 - rho, 2);
  EXPECT_NEAR(mean / expected, 1, 0.07);
  const double scatter = std::sqrt(squares / estimates - mean * mean) / mean;
  EXPECT_NEAR(said / estimates / scatter, 1, 0.4);
}

INSTANTIATE_TEST_SUITE_P(Cases, CorrelationTimes,
                         testing::Values(Case{0.3, 41}, Case{0.5, 41}, Case{0.5, 400}, Case{0.7, 100},
                                         Case{0.9, 400}));

// Ten series of 2 tau = 1, ten of 17/3, 400 frames: their mean is 10/3. One series knows its own to 0.3,
// relative, so that more than half of what it differs by from the mean is kept; series that are alike get one
// value.
TEST(CorrelationTime, KeepsWhatSeriesDifferBy) {
  std::mt19937_64 random(2);
  const auto fast = noise(0, 10, 400, random), slow = noise(0.7, 10, 400, random);
  Rows both(400, 20);
  both << fast, slow;
  const CorrelationTime unlike = correlation_time(both, one_run(400));
  EXPECT_GT(unlike.scatter, 0.4);
  constexpr double fast_time = 1, slow_time = 17.0 / 3, mean = 10.0 / 3;
  EXPECT_GT(unlike.of_series.head(10).mean(), fast_time);
  EXPECT_LT(unlike.of_series.head(10).mean(), (fast_time + mean) / 2);
  EXPECT_GT(unlike.of_series.tail(10).mean(), (slow_time + mean) / 2);
  EXPECT_LT(unlike.of_series.tail(10).mean(), slow_time * 1.3);
  EXPECT_GT(unlike.unknown_scatter, 0);
  EXPECT_LT(unlike.unknown_scatter, unlike.scatter / 2);
  const CorrelationTime alike = correlation_time(noise(0.5, 20, 400, random), one_run(400));
  EXPECT_LT(alike.scatter, 0.2);
  EXPECT_EQ(alike.unknown_scatter, 0);
  EXPECT_NEAR(alike.of_series.maxCoeff() / alike.of_series.minCoeff(), 1, 0.5);
}

// One series of 2 tau = 19 among 59 of 1, 200 frames: the window of all may see two or three lags of it. Its
// 2 tau is not told then, or not less than a third of what it is; one in a thousand of the others is taken
// for slow.
TEST(CorrelationTime, IsNotToldOfASlowOneAmongFastOnes) {
  std::mt19937_64 random(6);
  constexpr int trials = 40;
  int too_short = 0, fast_left_out = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Rows both(200, 60);
    both << noise(0, 59, 200, random), noise(0.9, 1, 200, random);
    const Eigen::ArrayXd times = correlation_time(both, one_run(200)).of_series;
    too_short += times[59] < 19.0 / 3 ? 1 : 0;
    fast_left_out += static_cast<int>(times.head(59).isNaN().count());
  }
  EXPECT_LE(too_short, trials / 20);
  EXPECT_LE(fast_left_out, 59 * trials / 1000 + 3);
}

TEST(CorrelationTime, IsNotToldWhereItIsBeyondAQuarterOfTheSeries) {
  std::mt19937_64 random(2);
  EXPECT_TRUE(std::isnan(correlation_time(noise(0.97, 50, 40, random), one_run(40)).time));
  EXPECT_FALSE(std::isnan(correlation_time(noise(0.5, 50, 40, random), one_run(40)).time));
}

// t of 9 degrees of freedom: 1.0587 at 68.27 %, 2.2622 at 95 %: (1.0587 + 2.2622/1.95996)/2.
TEST(ErrorDecision, WidensByStudentsT) {
  expect_measured(student_width(9), 1.1065, 5e-5);
  expect_measured(student_width(1e6), 1, 1e-5);
}

// x = 1.95996: (x^4 + 2 x^2 - 3)/18 = 1.079985, nothing at x = 1: half of it times g^2 = 4 times 19/18^2.
TEST(ErrorDecision, WidensForSkewness) {
  expect_measured(skewed_width(4, 20), 1 + 0.539992 * 4 * 19 / (18 * 18), 5e-6);
  EXPECT_EQ(skewed_width(0, 20), 1);
}

// 2 tau must be known to 0.2. Of 100 samples it is to 0.3, as it would be to 0.2 of 100 (0.3/0.2)^2; where it
// is known to 0.1, 25 samples do, and 8 must be left of 8 (1 + 0.1).
TEST(ErrorDecision, AsksHowWellTwoTauIsKnown) {
  CorrelationTime correlation;
  correlation.time = 1;
  correlation.uncertainty = 0.3;
  expect_measured(decide(correlation, 100).needed, 225, rounding);
  EXPECT_FALSE(decide(correlation, 100).given);
  correlation.uncertainty = 0.1;
  expect_measured(decide(correlation, 100).needed, 25, rounding);
  EXPECT_TRUE(decide(correlation, 100).given);
  expect_measured(decide(correlation, 30).needed, 8.8, rounding);
  correlation.unknown_scatter = 0.11;
  EXPECT_TRUE(decide(correlation, 100).unlike);
  EXPECT_FALSE(decide(correlation, 100).given);
}

// However badly 2 tau is known: as many runs are independent.
TEST(ErrorDecision, EightIndependentRunsDo) {
  CorrelationTime correlation;
  correlation.time = 1;
  correlation.uncertainty = 0.3;
  correlation.most = 1;
  EXPECT_TRUE(decide(correlation, 8).given);
  EXPECT_FALSE(decide(correlation, 7).given);
  // One of the eight is that of the mean.
  expect_measured(decide(correlation, 8).freedom, 7, rounding);
}

}  // namespace
}  // namespace mikromakro
