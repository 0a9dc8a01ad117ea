// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fit/fit_trials.h"
#include "measured_error.h"
#include "statistics/student_t.h"

namespace mikromakro {
namespace {

constexpr double r_i = 0.1032, v0 = 0.0074, s = 0.0127;

Eigen::ArrayXd ring_radii() {
  return Eigen::ArrayXd::LinSpaced(20, 0.107, 0.249);
}

Eigen::ArrayXd profile() {
  return v0 * (-(ring_radii() - r_i) / s).exp();
}

ExponentialProfile fit(const Eigen::ArrayXd& v) {
  return fit_exponential({ring_radii(), v, {}}, r_i);
}

// Blocks in which the whole profile is 1 + x of what it is: so is v0, and s stays.
ColumnWithoutBlocks in_step(const std::vector<double>& x, const std::vector<std::int64_t>& runs) {
  const auto count = static_cast<double>(x.size());
  double sum = 0;
  for (const double one : x) sum += 1 + one;
  ColumnWithoutBlocks blocks{Eigen::ArrayXXd(20, static_cast<Eigen::Index>(x.size())), runs, 5};
  for (std::size_t i = 0; i < x.size(); ++i)
    blocks.values.col(static_cast<Eigen::Index>(i)) = profile() * (sum - 1 - x[i]) / (count - 1);
  return blocks;
}

// Means of runs: 1 + x with x = -3 ... 4 per cent, two blocks each that differ by 2 per cent. The variance of
// eight numbers in a row is 6.
TEST(FitErrors, OfEightRunsAreThoseOfTheirMeans) {
  std::vector<double> x;
  std::vector<std::int64_t> runs;
  for (int run = 0; run < 8; ++run) {
    for (const double change : {-0.01, 0.01}) {
      x.push_back(0.01 * (run - 3) + change);
      runs.push_back(run);
    }
  }
  const FitErrors errors = errors_from_blocks(fit(profile()), in_step(x, runs), fit);
  const double error = v0 * 0.01 * std::sqrt(6.0 / 8);
  expect_measured(errors.half_width[0] / (student_t(0.95, 7) * error), 1, 1e-8);
  EXPECT_EQ(errors.freedom, 7);
  EXPECT_EQ(errors.method, "jackknife of runs");
  EXPECT_LT(errors.error[1], 1e-10 * s);
}

// Eight runs, one of two blocks, seven of one: shares 2/9 and 1/9, sum w^2 = 11/81, sum w^3 = 15/729: (1 -
// 11/81)^2/(11/81 - 30/729 + (11/81)^2) = 4900/742 degrees of freedom. With 1 + x of v0, the mean is that of
// all blocks.
TEST(FitErrors, OfRunsOfUnequalLength) {
  const std::vector<double> x = {-0.03, -0.03, -0.02, -0.01, 0, 0.01, 0.02, 0.03, 0.04};
  const FitErrors errors = errors_from_blocks(fit(profile()), in_step(x, {0, 0, 1, 2, 3, 4, 5, 6, 7}), fit);
  double mean = 0, square = 0;
  for (const double one : x) mean += one / 9;
  for (const double one : x) square += (one - mean) * (one - mean) / 9;
  constexpr double squares = 11.0 / 81;
  const double error = v0 * std::sqrt(squares * square / (1 - squares));
  EXPECT_EQ(errors.method, "jackknife of runs");
  expect_measured(errors.freedom, 4900.0 / 742, 1e-12);
  expect_measured(errors.half_width[0] / (student_t(0.95, errors.freedom) * error), 1, 1e-8);
}

// A run that is as long as all others together says what the mean is, and nothing of how runs differ.
TEST(FitErrors, AreNotOfRunsWhereOneIsMostOfThem) {
  std::vector<double> x(30, 0);
  std::vector<std::int64_t> runs(30, 0);
  for (std::size_t i = 0; i < 30; ++i)
    x[i] = 0.01 * (i % 2 == 0 ? 1 : -1) + (i < 23 ? 0 : 0.02 * (static_cast<double>(i) - 26));
  for (std::size_t i = 23; i < 30; ++i) runs[i] = static_cast<std::int64_t>(i) - 22;
  EXPECT_NE(errors_from_blocks(fit(profile()), in_step(x, runs), fit).method, "jackknife of runs");
}

// Runs of thirty blocks of noise of 1 % whose means are 10 % apart: four have the errors of their spread, 0,
// 1, 2, 3 tenths with a variance of 5/3, three have none.
TEST(FitErrors, OfRunsThatDifferAreOfTheirSpreadOrNone) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const int count : {3, 4}) {
    std::vector<double> x;
    std::vector<std::int64_t> runs;
    for (int run = 0; run < count; ++run) {
      for (int i = 0; i < 30; ++i) {
        runs.push_back(run);
        x.push_back(0.1 * run + 0.01 * normal(random));
      }
    }
    const FitErrors errors = errors_from_blocks(fit(profile()), in_step(x, runs), fit);
    EXPECT_NE(errors.remark.find("runs that differ by more than their frames explain"), std::string::npos)
        << errors.remark;
    EXPECT_EQ(errors.method, count == 3 ? "none" : "jackknife of runs");
    if (count == 3) continue;
    EXPECT_EQ(errors.freedom, 3);
    // The noise of 120 blocks: 2 % of the spread.
    EXPECT_NEAR(errors.half_width[0] / (student_t(0.95, 3) * v0 * 0.1 * std::sqrt(5.0 / 3 / 4)), 1, 0.05);
  }
}

// v0 and s change together as d v0/d v_i and d s/d v_i say: noise in one ring alone is a correlation of -1 or
// 1, of that sign. A single series knows 2 tau from 600 blocks.
TEST(FitErrors, CorrelationOfBothIsThatOfTheFit) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (const Eigen::Index ring : {0, 3}) {
    ColumnWithoutBlocks blocks = in_step(std::vector<double>(600, 0.0), std::vector<std::int64_t>(600, 0));
    for (Eigen::Index i = 0; i < 600; ++i) blocks.values(ring, i) *= 1 + 1e-6 * normal(random);
    const ExponentialProfile fitted = fit(profile());
    const FitErrors errors = errors_from_blocks(fitted, blocks, fit);
    const double product = fitted.change(0, ring) * fitted.change(1, ring);
    EXPECT_NEAR(errors.correlation, product < 0 ? -1 : 1, 1e-4) << ring;
  }
}

TEST(FitErrors, AreNotGivenWhereTheyCannotBeKnown) {
  const std::vector<std::int64_t> one_run(5, 0);
  const FitErrors few = errors_from_blocks(fit(profile()), in_step({0, 1, 2, 1, 0}, one_run), fit);
  EXPECT_TRUE(few.error.isNaN().all());
  EXPECT_EQ(few.method, "none");
  EXPECT_EQ(few.remark, "5 blocks of 5 frames, too few to estimate 2 tau");
  ColumnWithoutBlocks empty = in_step({0, 1, 2, 1, 0}, one_run);
  empty.values(3, 2) = std::nan("");
  EXPECT_EQ(errors_from_blocks(fit(profile()), empty, fit).remark,
            "the fit fails when one of the blocks is left out");
}

// Rings that all err by the same share are the whole profile times 1 + x, whose v0 errs by that share: the
// error is not below it.
TEST(FitErrors, OfRingsAreAsIfAllActedInOneDirection) {
  const ExponentialProfile fitted = fit(profile());
  const FitErrors errors = errors_from_rings(fitted, 0.01 * profile());
  for (Eigen::Index k = 0; k < 2; ++k) {
    double bound = 0;
    for (Eigen::Index i = 0; i < 20; ++i) bound += std::abs(fitted.change(k, i)) * 0.01 * profile()[i];
    expect_measured(errors.error[k] / bound, 1, 1e-12);
  }
  EXPECT_GT(errors.error[0], 0.01 * v0);
  Eigen::ArrayXd one_unknown = 0.01 * profile();
  one_unknown[4] = std::nan("");
  EXPECT_EQ(errors_from_rings(fitted, one_unknown).method, "none");
}

struct Scene {
  int rings;
  double length, rho, rho_behind;
};

const std::vector<Scene> scenes = {
    {20, 0, 0, -1}, {60, 0.004, 0.5, -1}, {20, 0.008, 0.7, -1}, {60, 0.015, 0, -1}, {60, 0.015, 0.5, -1}};
// Behind the zone rings have no memory, or less.
const std::vector<Scene> slow_zones = {{20, 0.008, 0.7, 0}, {60, 0.008, 0.7, 0}, {60, 0.008, 0.7, 0.3}};

FitCoverage mean_coverage(const std::vector<Scene>& scenes, const MakeFitErrors& errors, int count) {
  FitCoverage mean{0, {0, 0}, {0, 0}, {0, 0}};
  for (const Scene& scene : scenes) {
    const FitCoverage one =
        coverage({scene.rings, scene.length, scene.rho, scene.rho_behind, 100, 1, 0.25, 0, 0, count}, errors);
    mean.given += one.given / static_cast<double>(scenes.size());
    mean.one_sigma += one.one_sigma / static_cast<double>(scenes.size());
    mean.two_sided += one.two_sided / static_cast<double>(scenes.size());
  }
  return mean;
}

void record(const FitCoverage& covered) {
  testing::Test::RecordProperty(
      "covered", fmt::format("{:.3f} {:.3f} and {:.3f} {:.3f}", covered.one_sigma[0], covered.one_sigma[1],
                             covered.two_sided[0], covered.two_sided[1]));
}

// 68.3 and 95 %, and 3 and 1 % more since the larger of two 2 tau counts; 2000 profiles scatter by 1 and 0.5
// %.
TEST(FitCoverageOf, BlocksIsWhatTheySay) {
  const FitCoverage covered = mean_coverage(scenes, fit_errors_of_blocks, 400);
  record(covered);
  EXPECT_GT(covered.given, 0.95);
  for (const int k : {0, 1}) {
    EXPECT_NEAR(covered.one_sigma[k], 0.725, 0.04);
    EXPECT_NEAR(covered.two_sided[k], 0.96, 0.02);
  }
}

// Rings far from the wheel say nothing about how slowly v0 and s change: 60 and 90 % if they are asked.
TEST(FitCoverageOf, BlocksIsThatOfTheRingsThatMatter) {
  const FitCoverage covered = mean_coverage(slow_zones, fit_errors_of_blocks, 400);
  record(covered);
  EXPECT_GT(covered.given, 0.85);
  for (const int k : {0, 1}) {
    EXPECT_NEAR(covered.one_sigma[k], 0.7, 0.04);
    EXPECT_NEAR(covered.two_sided[k], 0.95, 0.02);
  }
}

// Not less than 95 % less three standard errors; the scatter about the line alone has a third of that.
TEST(FitCoverageOf, RingsIsNotLessThanTheySay) {
  const FitCoverage covered = mean_coverage(scenes, fit_errors_of_rings, 400);
  record(covered);
  EXPECT_GT(covered.two_sided.minCoeff(), 0.95 - 0.015);
  EXPECT_LT(mean_coverage(scenes, fit_errors_of_scatter, 100).two_sided.maxCoeff(), 0.5);
}

// Packings that last as long as the run: eight runs know it. One number for both shares covers 70.9 % where
// there are 7 degrees of freedom; 800 trials scatter by 1.6 and 0.8 %: three times that.
TEST(FitCoverageOf, EightRunsCountsWhatDiffersFromRunToRun) {
  const FitCoverage covered = coverage({20, 0.008, 0.5, -1, 32, 8, 0.25, 0, 0.3, 800}, fit_errors_of_blocks);
  record(covered);
  for (const int k : {0, 1}) {
    EXPECT_NEAR(covered.one_sigma[k], 0.709, 0.048);
    EXPECT_NEAR(covered.two_sided[k], 0.95, 0.024);
  }
}

}  // namespace
}  // namespace mikromakro
