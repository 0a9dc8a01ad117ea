// Standard errors against artificial runs whose truth is known; the whole tables: build/bin/coverage_bench.
#include <gtest/gtest.h>

#include <cmath>

#include "averaging/error_trials.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

struct Case {
  double rho;
  int frames;
  int runs;
};

class ErrorsOfAField : public testing::TestWithParam<Case> {};

Trials field_of(const Case& one, Eigen::Index volumes, int count) {
  Trials trials;
  trials.run = [one, noise = CorrelatedNoise(one.rho, volumes, 1)](auto& random) {
    return noise(one.frames, random);
  };
  trials.runs = one.runs;
  trials.truth = Rows::Zero(volumes, 1);
  trials.count = count;
  return trials;
}

void record(const Coverage& covered) {
  testing::Test::RecordProperty("given", fmt::format("{:.3f}", covered.given));
  testing::Test::RecordProperty("one_sigma", fmt::format("{:.3f}", covered.one_sigma));
  testing::Test::RecordProperty("two_sided", fmt::format("{:.3f}", covered.two_sided));
}

// As promised: 68.3 +- 4 % and 95 +- 2 %, of which 4000 errors (200 trials of 20 volumes) that share their 2
// tau scatter by 1 and 0.5 %. Ten effective samples or more, so that most of the trials have errors.
TEST_P(ErrorsOfAField, CoverTheTruthAsOftenAsTheySay) {
  const Coverage covered = coverage(field_of(GetParam(), 20, 200), errors_of_field);
  record(covered);
  EXPECT_GT(covered.given, 0.6);
  EXPECT_NEAR(covered.one_sigma, 0.683, 0.04);
  EXPECT_NEAR(covered.two_sided, 0.95, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cases, ErrorsOfAField,
                         testing::Values(Case{0, 20, 1}, Case{0, 100, 1}, Case{0.3, 20, 1}, Case{0.3, 64, 1},
                                         Case{0.5, 41, 1}, Case{0.5, 1000, 1}, Case{0.7, 64, 1},
                                         Case{0.7, 100, 1}, Case{0.9, 200, 1}, Case{0.9, 1000, 1},
                                         Case{0.5, 41, 4}, Case{0.9, 41, 8}));

// Six effective samples and fewer.
TEST(ErrorsOfOneField, AreSeldomGivenBelowTenSamples) {
  for (const Case& one : {Case{0.3, 10, 1}, Case{0.7, 20, 1}, Case{0.9, 100, 1}})
    EXPECT_LT(coverage(field_of(one, 20, 100), errors_of_field).given, 0.1) << one.rho << ' ' << one.frames;
}

// A single series: 2 tau is known badly, and none is given where that decides, as with 11 samples (one trial
// in 50 has an error); of 500 samples 68 to 78 % are covered: 2 tau is never taken below 1. 500 trials
// scatter by 2 and 1 %.
TEST(ErrorsOfASeries, CoverTheTruthOrAreNotGiven) {
  EXPECT_LT(coverage(field_of({0.7, 64, 1}, 1, 500), errors_of_field).given, 0.05);
  const Coverage covered = coverage(field_of({0.3, 1000, 1}, 1, 500), errors_of_field);
  record(covered);
  EXPECT_GT(covered.given, 0.8);
  EXPECT_NEAR(covered.one_sigma, 0.74, 0.07);
  EXPECT_NEAR(covered.two_sided, 0.965, 0.025);
}

// The quotient of sums, 20 + y over 10 + x, is solved from their means.
TEST(ErrorsOfOneField, CoverQuotients) {
  Trials trials = field_of({0.5, 41, 1}, 20, 200);
  trials.run = [noise = CorrelatedNoise(0.5, 20, 2)](auto& random) { return noise(41, random); };
  trials.solve = [](const Rows& sums) { return Rows((sums.col(1) + 20) / (sums.col(0) + 10)); };
  trials.truth = Rows::Constant(20, 1, 2);
  const Coverage covered = coverage(trials, errors_of_field);
  record(covered);
  EXPECT_NEAR(covered.one_sigma, 0.683, 0.04);
  EXPECT_NEAR(covered.two_sided, 0.95, 0.02);
}

}  // namespace
}  // namespace mikromakro
