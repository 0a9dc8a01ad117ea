// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/between_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measured_error.h"
#include "statistics/error_trials.h"
#include "statistics/f_distribution.h"

namespace mikromakro {
namespace {

// Closed form for two degrees of freedom of the numerator: (1 + 2 x/n)^(-n/2). Printed tables: 5 % at 3.3258
// (5 and 10), 2.7109 (5 and 20); five digits, of which the tail has a density of 0.04.
TEST(FDistribution, HasClosedFormsAndAgreesWithTables) {
  expect_measured(f_tail(3, 2, 10) / std::pow(1.6, -5), 1, 1e-12);
  expect_measured(f_tail(0, 2, 10), 1, 1e-15);
  expect_measured(f_tail(3.3258, 5, 10), 0.05, 1e-5);
  expect_measured(f_tail(2.7109, 5, 20), 0.05, 1e-5);
}

// Runs of two values and of one, means 1 and 4: shares 2/3 and 1/3, mean 2, sum w (x - mean)^2 = 2, sum w^2 =
// 5/9: 5/9 2/(4/9) = 5/2. Of two runs there is one degree of freedom, however long they are.
TEST(RunMeans, HaveTheSpreadOfTheirShares) {
  Rows series(3, 1);
  series << 0, 2, 4;
  const RunMeans means = run_means(series, {0, 0, 1});
  EXPECT_EQ(means.mean(0, 0), 1);
  EXPECT_EQ(means.mean(1, 0), 4);
  expect_measured(means.variance_of_mean()[0], 2.5, 1e-12);
  expect_measured(means.freedom(), 1, 1e-12);
  expect_measured(run_means(Rows::Random(8, 1), {0, 0, 1, 1, 2, 2, 3, 3}).freedom(), 3, 1e-12);
}

struct Case {
  double rho;
  std::vector<int> lengths;
  Eigen::Index series;
};

class RunsThatDoNotDiffer : public testing::TestWithParam<Case> {};

// Of 400 trials chi^2 is 1 on average: the mean of 20 series of one degree of freedom and more scatters by
// 0.32/20 or less, of 400 by 1 series of 1 degree by 0.07; three times that, and 4 % for 2 tau. As many as
// said differ by chance: 1 %, with the scatter of 400 and what is not exact in the distribution, below 3 %.
// None is a copy.
TEST_P(RunsThatDoNotDiffer, HaveChiSquareOne) {
  const auto& [rho, lengths, series] = GetParam();
  std::mt19937_64 random(5);
  constexpr int trials = 400;
  double sum = 0, differ = 0, known = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<std::int64_t> runs;
    std::vector<Rows> frames;
    for (std::size_t run = 0; run < lengths.size(); ++run) {
      for (const Rows& frame : CorrelatedNoise(rho, 1, series)(lengths[run], random)) {
        frames.push_back(frame);
        runs.push_back(static_cast<std::int64_t>(run));
      }
    }
    Rows all(static_cast<Eigen::Index>(frames.size()), series);
    for (std::size_t i = 0; i < frames.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = frames[i].row(0);
    const BetweenRuns between = between_runs(all, runs);
    if (std::isnan(between.chi_square)) continue;
    ++known;
    sum += between.chi_square;
    differ += between.differ() ? 1 : 0;
    EXPECT_FALSE(between.repeat());
  }
  testing::Test::RecordProperty("chi_square", fmt::format("{:.3f}", sum / known));
  testing::Test::RecordProperty("differ", fmt::format("{:.4f}", differ / known));
  EXPECT_GT(known, 0.9 * trials);
  EXPECT_NEAR(sum / known, 1, series == 1 ? 0.25 : 0.09);
  EXPECT_LT(differ / known, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Cases, RunsThatDoNotDiffer,
                         testing::Values(Case{0, {20, 20}, 20}, Case{0, {100, 100}, 20},
                                         Case{0.5, {41, 41}, 20}, Case{0.5, {100, 100, 100}, 20},
                                         Case{0.7, {100, 60, 40, 20}, 20},
                                         Case{0.5, {200, 20, 20, 20, 20, 20, 20, 20}, 20},
                                         Case{0.9, {200, 200, 200, 200}, 20}, Case{0, {100, 100}, 1},
                                         Case{0, {10, 10, 10, 10, 10, 10, 10, 10}, 200}));

// Runs that do not change at all but from one to another differ; those of one frame tell nothing.
TEST(BetweenRuns, AreKnownOnlyWithinRuns) {
  Rows series(8, 1);
  series << 1, 1, 1, 1, 2, 2, 2, 2;
  EXPECT_TRUE(between_runs(series, {0, 0, 0, 0, 1, 1, 1, 1}).differ());
  EXPECT_TRUE(std::isnan(between_runs(Rows::Random(8, 1), {0, 1, 2, 3, 4, 5, 6, 7}).chi_square));
  EXPECT_TRUE(std::isnan(between_runs(Rows::Random(8, 1), {0, 0, 0, 0, 0, 0, 0, 0}).chi_square));
}

}  // namespace
}  // namespace mikromakro
