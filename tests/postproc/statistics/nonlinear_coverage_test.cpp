// SPDX-License-Identifier: GPL-2.0-or-later
// Errors of deviators, principal values, directions and mu_c against known tensors; the whole tables:
// build/bin/coverage_bench 500 tensors.
#include <gtest/gtest.h>

#include "statistics/field_trials.h"

namespace mikromakro {
namespace {

constexpr int count = 100;
constexpr Eigen::Index trace = 0, deviator = 1, angle = 2, major = 3, minor = 4;

FieldTrials layout(int runs) {
  return {20, runs, runs == 1 ? 64 : 20};
}

Coverage covered(int runs, double ratio, Eigen::Index column) {
  const FieldTrials trials = axes_trials(layout(runs), Eigen::ArrayXd::Constant(20, ratio));
  return coverage_of_column(trials, column, 20, count);
}

class ErrorsOfTensors : public testing::TestWithParam<int> {};

// Of 2000 errors, which scatter by 1 and 0.5 %. Those of isotropic tensors covered 39 and 84 %: without the
// bias, 1.25 standard errors; deviators of one standard error and more are covered too often by twice the
// curvature. None is withheld, hence none is selected.
TEST_P(ErrorsOfTensors, CoverWeakDeviators) {
  for (const double ratio : {0., 1., 2., 5.}) {
    for (const Eigen::Index column : {trace, deviator, major, minor}) {
      const Coverage made = covered(GetParam(), ratio, column);
      EXPECT_GT(made.given, 0.97) << ratio << ' ' << column;
      EXPECT_GT(made.one_sigma, 0.60) << ratio << ' ' << column;
      EXPECT_GT(made.two_sided, 0.92) << ratio << ' ' << column;
    }
  }
}

// A direction is without meaning for an isotropic tensor; 64, 91 % were covered at a deviator of two. Of
// those selected at three (one in seven), 59 and 88 % without the widening by 8 (e/L)^2, 65 and 91 to 93 %
// with it; 300 of them scatter by 3 and 1.6 %, which is allowed twice, 2000 by 1 and 0.5 %.
TEST_P(ErrorsOfTensors, AreOfDirectionsThatAreDetermined) {
  EXPECT_LT(covered(GetParam(), 0, angle).given, 0.01);
  EXPECT_LT(covered(GetParam(), 1, angle).given, 0.04);
  for (const double ratio : {3., 5., 10.}) {
    const Coverage made = covered(GetParam(), ratio, angle);
    EXPECT_GT(made.one_sigma, ratio < 4 ? 0.65 - 0.06 : 0.68 - 0.02) << ratio;
    EXPECT_GT(made.two_sided, ratio < 4 ? 0.91 - 0.032 : 0.94 - 0.01) << ratio;
  }
  EXPECT_GT(covered(GetParam(), 10, angle).given, 0.97);
}

// A quotient with a denominator of three standard errors covers 70 and 87 %, all misses low; of twenty it is
// as good as linear.
TEST_P(ErrorsOfTensors, OfMuCAreWithheldWhereTheCurvatureIsInsignificant) {
  const auto of = [](double ratio) {
    return coverage_of_column(stiffness_trials(layout(GetParam()), ratio, 0.2), 0, 20, count);
  };
  EXPECT_LT(of(3).given, 0.02);
  const Coverage made = of(20);
  EXPECT_GT(made.given, 0.97);
  EXPECT_NEAR(made.one_sigma, 0.70, 0.04);
  EXPECT_NEAR(made.two_sided, 0.95, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Runs, ErrorsOfTensors, testing::Values(1, 8));

}  // namespace
}  // namespace mikromakro
