// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/block_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measured_error.h"
#include "statistics/error_trials.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

Rows row(std::initializer_list<double> values) {
  Rows row(1, static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) row(0, i++) = value;
  return row;
}

Rows same(const Rows& sums) {
  return sums;
}

TimeAverage average_of(const std::vector<double>& series, std::size_t most_blocks = 64) {
  TimeAverage average(most_blocks);
  for (const double value : series) average.add(row({value}));
  return average;
}

BlockErrors errors_of(const TimeAverage& average, const Solver& solve) {
  return block_errors(average, solve, {{"all", solve(average.mean()).cols()}});
}

// 0, 1, 2, ... 8 in at most 4 blocks: the fifth one merges 0 1, 2 3 and leaves 4 open; 4 5 and 6 7 follow, 8
// is open.
TEST(TimeAverage, KeepsBlocksOfPowersOfTwo) {
  const TimeAverage average = average_of({0, 1, 2, 3, 4, 5, 6, 7, 8}, 4);
  EXPECT_EQ(average.frames(), 9);
  EXPECT_EQ(average.mean()(0, 0), 4);
  EXPECT_EQ(average.block_length(), 2);
  ASSERT_EQ(average.blocks().size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(average.blocks()[i](0, 0), 0.5 + 2.0 * static_cast<double>(i));
}

TEST(TimeAverage, BlocksDoNotGrowWithTheNumberOfFrames) {
  TimeAverage average(64);
  for (int i = 0; i < 10000; ++i) average.add(row({1.0 * i}));
  EXPECT_EQ(average.block_length(), 256);
  EXPECT_EQ(average.blocks().size(), 39U);
  // Block k holds 256 k ... 256 k + 255.
  EXPECT_EQ(average.blocks()[38](0, 0), 256 * 38 + 127.5);
}

// Means of blocks of a series with the run of each of its values.
std::vector<double> blocks_of(const std::vector<std::pair<double, int>>& series, TimeAverage& average) {
  for (const auto& [value, run] : series) average.add(row({value}), run);
  std::vector<double> means;
  for (const Rows& block : average.blocks()) means.push_back(block(0, 0));
  return means;
}

// The fifth value makes blocks of two: 0 1 and 10 11; 2 is left over in the first run, 15 in the second, 20
// in the third.
TEST(TimeAverage, BlocksBelongToOneRun) {
  TimeAverage average(4);
  const auto blocks = blocks_of(
      {{0, 0}, {1, 0}, {2, 0}, {10, 1}, {11, 1}, {13, 1}, {14, 1}, {15, 1}, {20, 2}, {30, 3}, {31, 3}},
      average);
  EXPECT_EQ(average.block_length(), 2);
  EXPECT_EQ(blocks, (std::vector<double>{0.5, 10.5, 13.5, 30.5}));
  EXPECT_EQ(average.runs(), (std::vector<std::int64_t>{0, 1, 1, 3}));
  EXPECT_EQ(average.frames(), 11);
  expect_measured(average.mean()(0, 0), 147.0 / 11, rounding);
}

// Of the odd block at the end the first half of a longer one is made only where the run goes on.
TEST(TimeAverage, AnOpenBlockEndsWithItsRun) {
  TimeAverage average(2);
  EXPECT_EQ(blocks_of({{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 1}, {6, 1}}, average),
            (std::vector<double>{0.5, 3.5}));
}

TEST(TimeAverage, ManyRunsOfOneFrameAreAsManyBlocks) {
  TimeAverage average(64);
  for (int run = 0; run < 200; ++run) average.add(row({1.0 * run}), run);
  EXPECT_EQ(average.block_length(), 1);
  EXPECT_EQ(average.blocks().size(), 200U);
}

// Of sixty numbers in a volume: 2^22/8/60 = 8738 blocks for one, at most 1024; 436 for twenty, as a power of
// two; 64 for many.
TEST(TimeAverage, KeepsMoreBlocksOfFewNumbers) {
  EXPECT_EQ(suitable_blocks(60), 1024U);
  EXPECT_EQ(suitable_blocks(20 * 60), 256U);
  EXPECT_EQ(suitable_blocks(3600 * 60), 64U);
}

// 512 values 1 and -1 by turns: their correlation is negative and does not count, standard error of the mean
// of 512 values sqrt(512/511/512), but for what it is wider for its uncertainty.
TEST(BlockErrors, JackknifeOfAMeanIsItsStandardError) {
  std::vector<double> series;
  for (int i = 0; i < 256; ++i) series.insert(series.end(), {1, -1});
  const BlockErrors errors = errors_of(average_of(series, 512), same);
  const double widening = errors.fields[0].decision.widening;
  EXPECT_GT(widening, 1);
  expect_measured(errors.error(0, 0) / widening, std::sqrt(1.0 / 511), rounding);
  expect_measured(errors.effective_samples()[0], 512, rounding);
  expect_measured(errors.times_of_fields()(0, 0), 1, rounding);
}

// The quotient of y = 2 x is 2 in each frame, however x fluctuates: the mean of quotients and the quotient of
// means agree, and the jackknife must see both fluctuate together; with an independent y it is that of the
// linearised quotient, err^2 = (err_y^2 + q^2 err_x^2)/x^2, to the next order in 1/blocks: 10 %.
// The major axis of vectors about 90 degrees, which is -90 degrees: its error is that of the same vectors
// about 0.
TEST(BlockErrors, OfAnglesGoAroundTheirSeam) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 0.1);
  TimeAverage there(1024), here(1024);
  // Their mean lies on the seam, so that it is on either side without one of the blocks.
  Eigen::ArrayXd across(1000);
  for (double& number : across) number = noise(random);
  across -= across.mean();
  for (const double number : across) {
    const double along = 1 + noise(random);
    there.add(row({-along, number}));
    here.add(row({along, -number}));
  }
  // Half of the angle of a double vector, as of a tensor's deviator.
  const Solver angle = [](const Rows& sums) {
    return row({90 / std::acos(-1.0) * std::atan2(sums(0, 1), sums(0, 0))});
  };
  const std::vector<ColumnsOfField> fields = {{"axes", 1, {{"angle", "degree", "-", "", 180}}}};
  const double wanted = block_errors(here, angle, fields).error(0, 0);
  // 0.1/2 of a radian over sqrt(1000), within the uncertainty of a variance of 1000 and of 2 tau.
  EXPECT_NEAR(wanted, 0.05 * 180 / std::acos(-1.0) / std::sqrt(1000.0), 0.15 * wanted);
  EXPECT_NEAR(block_errors(there, angle, fields).error(0, 0), wanted, 1e-9 * wanted);
}

TEST(BlockErrors, QuotientsAreSolvedBeforeTheyAreCompared) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr int frames = 400;
  TimeAverage average(frames);
  for (int i = 0; i < frames; ++i) {
    const double x = 10 + normal(random);
    average.add(row({x, 2 * x, 20 + normal(random)}));
  }
  const auto solve = [](const Rows& sums) {
    Rows columns(1, 4);
    columns << sums(0, 1) / sums(0, 0), sums(0, 2) / sums(0, 0), sums(0, 0), sums(0, 2);
    return columns;
  };
  const BlockErrors errors = errors_of(average, solve);
  EXPECT_TRUE(std::isnan(errors.error(0, 0)) || errors.error(0, 0) < rounding);
  const double linear = std::hypot(errors.error(0, 3), 2 * errors.error(0, 2)) / 10;
  EXPECT_NEAR(errors.error(0, 1) / linear, 1, 0.1);
}

// 40 runs that each keep their value for 8 frames (2 tau = 8): errors of runs whose order is by chance, and
// of ascending ones, which would look like one long drift if the runs went on in each other.
TEST(BlockErrors, RunsDoNotCorrelateWithEachOther) {
  TimeAverage by_turns(64);
  TimeAverage ascending(64);
  for (int run = 0; run < 40; ++run) {
    for (int frame = 0; frame < 8; ++frame) {
      by_turns.add(row({1.0 * (run * 17 % 40)}), run);
      ascending.add(row({1.0 * run}), run);
    }
  }
  const BlockErrors errors = errors_of(ascending, same);
  EXPECT_TRUE(errors.any());
  expect_measured(errors.error(0, 0), errors_of(by_turns, same).error(0, 0), rounding);
}

// Seven frames of a hundred series, and a drift that is one long correlation: nan, never a small number.
// Twelve frames do.
TEST(BlockErrors, AreNanForTooFewFrames) {
  std::mt19937_64 random(3);
  TimeAverage average;
  const std::vector<Rows> frames = CorrelatedNoise(0, 100, 1)(12, random);
  for (int i = 0; i < 7; ++i) average.add(frames[static_cast<std::size_t>(i)]);
  EXPECT_FALSE(errors_of(average, same).any());
  for (int i = 7; i < 12; ++i) average.add(frames[static_cast<std::size_t>(i)]);
  EXPECT_TRUE(errors_of(average, same).error.isFinite().all());
  std::vector<double> drift;
  drift.reserve(1000);
  for (int i = 0; i < 1000; ++i) drift.push_back(i);
  const BlockErrors of_drift = errors_of(average_of(drift), same);
  EXPECT_FALSE(of_drift.any());
  EXPECT_TRUE(std::isnan(of_drift.effective_samples()[0]) && std::isnan(of_drift.times_of_fields()(0, 0)));
}

// Of two fields in one table the noise has errors, the drift has none.
TEST(BlockErrors, EachFieldDecidesForItself) {
  std::mt19937_64 random(3);
  TimeAverage average;
  int frame = 0;
  for (Rows rows : CorrelatedNoise(0, 20, 3)(40, random)) {
    rows.col(2) = ++frame + 0.1 * rows.col(2);
    average.add(rows);
  }
  const BlockErrors errors = block_errors(average, same, {{"noise", 2}, {"drift", 1}});
  EXPECT_TRUE(errors.error.leftCols(2).isFinite().all());
  EXPECT_TRUE(errors.error.col(2).isNaN().all());
  EXPECT_TRUE(errors.fields[0].decision.given);
  EXPECT_FALSE(errors.fields[1].decision.given);
  EXPECT_TRUE(errors.times_of_fields().col(0).isFinite().all());
  EXPECT_TRUE(errors.times_of_fields().col(1).isNaN().all());
}

TEST(BlockErrors, AreNanForWhatDoesNotFluctuate) {
  const BlockErrors errors = errors_of(average_of(std::vector<double>(100, 0.3)), same);
  EXPECT_TRUE(std::isnan(errors.error(0, 0)));
  EXPECT_TRUE(std::isnan(errors.effective_samples()[0]));
  // Rounding is no fluctuation; m blocks make it m times larger.
  for (const std::size_t blocks : {64, 1024}) {
    for (const double value : {0.251, 0.26, 0.3, 1.01}) {
      std::vector<double> rounded(blocks, value);
      for (std::size_t i = 0; i < rounded.size(); i += 3) rounded[i] *= 1 + 2e-13;
      EXPECT_EQ(errors_of(average_of(rounded, blocks), same).fields[0].series, 0) << blocks << ' ' << value;
    }
  }
}

TEST(BlockErrors, AreNanForWhatIsUndefinedWithoutABlock) {
  TimeAverage average;
  for (int i = 0; i < 20; ++i) average.add(row({i == 3 ? 1.0 : 0.0}));
  const BlockErrors errors = errors_of(average, [](const Rows& sums) { return Rows(sums / sums); });
  EXPECT_TRUE(std::isnan(errors.error(0, 0)));
}

// Thirty volumes, in ten of which there is a disc at all times, in the others for five frames now and then; a
// velocity keeps for a visit. Of one or two visits nothing tells how the next would differ.
TEST(BlockErrors, AreNanForVolumesThatAreSeldomOccupied) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  constexpr Eigen::Index count = 30, always = 10;
  TimeAverage average(200);
  Eigen::ArrayXi left = Eigen::ArrayXi::Zero(count), visits = left;
  Eigen::ArrayXd velocity = Eigen::ArrayXd::Zero(count);
  for (int frame = 0; frame < 200; ++frame) {
    Rows sums = Rows::Zero(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
      if (left[i] == 0 && (i < always || uniform(random) < 0.01)) {
        left[i] = i < always ? 1 : 5;
        velocity[i] = normal(random);
        ++visits[i];
      }
      if (left[i] == 0) continue;
      --left[i];
      sums.row(i) << 1, velocity[i] + 0.05 * normal(random);
    }
    average.add(sums);
  }
  const BlockErrors errors =
      block_errors(average, [](const Rows& sums) { return Rows(sums.col(1) / sums.col(0)); }, {{"v", 1}});
  EXPECT_TRUE(errors.error.topRows(always).isFinite().all());
  ASSERT_TRUE((visits.tail(count - always) < 8).all() && (visits.tail(count - always) > 0).any());
  EXPECT_TRUE(errors.error.bottomRows(count - always).isNaN().all());
}

// Twenty volumes of white noise in `lengths.size()` runs, which are off by `offset` by turns.
TimeAverage runs_that_differ(const std::vector<int>& lengths, double offset, std::mt19937_64& random) {
  TimeAverage average(1024);
  for (std::size_t run = 0; run < lengths.size(); ++run)
    for (const Rows& rows : CorrelatedNoise(0, 20, 1)(lengths[run], random))
      average.add(rows + (run % 2 == 0 ? offset : -offset), static_cast<std::int64_t>(run));
  return average;
}

// Eight runs of 25 frames: chi^2 is 1 + 25 8/7 d^2 for runs that are off by d and -d by turns, whatever they
// are off by. Twenty volumes of 7 degrees of freedom scatter by 0.12, offsets by sqrt(2 (140 + 2 25 8 20
// d^2))/140 of chi^2: 0.06 and less; the variance of 192 values by 0.02: three times that, and 0.04 for 2
// tau.
TEST(BlockErrors, TellHowRunsDiffer) {
  std::mt19937_64 random(4);
  for (const double offset : {0.0, 0.5, 3.0}) {
    const TimeAverage average = runs_that_differ(std::vector<int>(8, 25), offset, random);
    const FieldErrors made = errors_of(average, same).fields[0];
    ASSERT_TRUE(made.decision.given);
    EXPECT_TRUE(made.decision.by_runs);  // as eight runs always are
    EXPECT_EQ(made.between.differ(), offset > 0);
    EXPECT_NEAR(made.between.chi_square / (1 + 25 * 8 * offset * offset / 7), 1, offset > 0 ? 0.22 : 0.4);
    EXPECT_FALSE(made.between.repeat());
  }
}

// Errors of runs that differ are those of their spread: of means 1, -1 by turns and little noise, sqrt(8/7/8)
// times the width of Student's t of seven degrees of freedom. Three runs do not tell, nor do runs of which
// one is nearly all.
TEST(BlockErrors, OfRunsThatDifferAreOfTheirSpread) {
  std::mt19937_64 random(4);
  const Solver shrink = [](const Rows& sums) { return Rows(1 + 1e-3 * sums); };
  const BlockErrors errors = errors_of(runs_that_differ(std::vector<int>(8, 25), 1e3, random), shrink);
  EXPECT_NEAR(errors.error(0, 0) / (student_width(7) * std::sqrt(1.0 / 7)), 1, 1e-3);
  EXPECT_EQ(errors.fields[0].decision.freedom, 7);
  expect_measured(errors.effective_samples()[0], 8, rounding);
  for (const std::vector<int>& lengths :
       {std::vector<int>{100, 100, 100}, std::vector<int>{400, 20, 20, 20}}) {
    const BlockErrors none = errors_of(runs_that_differ(lengths, 1, random), same);
    EXPECT_FALSE(none.any());
    EXPECT_TRUE(none.fields[0].decision.by_runs);
  }
}

// One of two hundred volumes is off by 0.3 and -0.3 by turns: chi^2 of all does not show it. From four runs
// on its error is that of the spread of their means m_r, sqrt(sum (m_r - m)^2/(R (R - 1))) times the width of
// Student's t; from two it has none. Those of the others are 1/sqrt(n), widened by little.
TEST(BlockErrors, OfAVolumeThatDiffersAmongOthersAreOfItsSpread) {
  std::mt19937_64 random(4);
  for (const int runs : {2, 4}) {
    TimeAverage average(1024);
    Eigen::ArrayXd means = Eigen::ArrayXd::Zero(runs);
    for (int run = 0; run < runs; ++run)
      for (Rows rows : CorrelatedNoise(0, 200, 1)(100, random)) {
        rows(0, 0) += run % 2 == 0 ? 0.3 : -0.3;
        means[run] += rows(0, 0) / 100;
        average.add(rows, run);
      }
    const BlockErrors errors = errors_of(average, same);
    EXPECT_FALSE(errors.fields[0].decision.by_runs);
    if (runs == 2) {
      EXPECT_TRUE(std::isnan(errors.error(0, 0)));
    } else {
      const double spread = std::sqrt((means - means.mean()).square().sum() / (runs * (runs - 1)));
      expect_measured(errors.error(0, 0) / (student_width(runs - 1) * spread), 1, 1e-9);
    }
    EXPECT_NEAR(errors.error.bottomRows(199).isNaN().select(0, errors.error.bottomRows(199)).sum() / 199 *
                    std::sqrt(100.0 * runs),
                1, 0.15);
  }
}

// A run that is there twice, among others, with other numbers of its steps or fewer digits.
TEST(BlockErrors, TellThatOneRunIsThereTwice) {
  std::mt19937_64 random(4);
  std::vector<std::vector<Rows>> runs(4);
  for (std::vector<Rows>& run : runs) run = CorrelatedNoise(0.5, 20, 1)(50, random);
  for (const bool twice : {false, true}) {
    TimeAverage average(1024);
    for (std::size_t run = 0; run < 4; ++run)
      for (const Rows& rows : runs[twice && run == 3 ? 1 : run])
        average.add((1e5 * rows).round() / 1e5, static_cast<std::int64_t>(run));
    EXPECT_EQ(errors_of(average, same).fields[0].between.repeat(), twice);
  }
}

}  // namespace
}  // namespace mikromakro
