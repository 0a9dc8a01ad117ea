#include "fit/exponential_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/error.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

constexpr double r_i = 0.1032;
constexpr double width = 0.0127;  // the seed's s

ProfilePoints exact_profile(double v0, int rings) {
  ProfilePoints points;
  points.r = Eigen::ArrayXd::LinSpaced(rings, r_i + 0.00125, r_i + 0.075);
  points.v = v0 * (-(points.r - r_i) / width).exp();
  return points;
}

// The minimum of the sum of squares is found to rounding since it is zero: 1e-10 is ample.
TEST(ExponentialProfile, ExactDataGiveBackTheirParameters) {
  for (const double v0 : {6.66e-3, -6.66e-3, 1.0}) {
    const ExponentialProfile fit = fit_exponential(exact_profile(v0, 60), r_i);
    expect_measured(fit.v0.value / v0, 1, 1e-10);
    expect_measured(fit.s.value / width, 1, 1e-10);
    EXPECT_EQ(fit.points, 60);
    EXPECT_LT(fit.residual_rms, 1e-12 * std::abs(v0));
  }
}

TEST(ExponentialProfile, RingsWithoutValueAreLeftOut) {
  ProfilePoints points = exact_profile(1, 20);
  points.v[3] = std::nan("");
  const ExponentialProfile fit = fit_exponential(points, r_i);
  EXPECT_EQ(fit.points, 19);
  expect_measured(fit.s.value / width, 1, 1e-10);
}

// 400 profiles with Gaussian noise: the 95 % intervals hold the truth in 95 % of them. The standard error of
// such a share is sqrt(0.95 * 0.05/400) = 1.1 %; four of them.
TEST(ExponentialProfile, IntervalsCoverTheTruthAsOftenAsTheySay) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.01);
  int v0_covered = 0;
  int s_covered = 0;
  constexpr int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    ProfilePoints points = exact_profile(1, 30);
    points.error = Eigen::ArrayXd::Constant(30, 1.0);
    for (Eigen::Index i = 0; i < 30; ++i) {
      // Errors that differ by a factor of 3, known up to a common factor.
      points.error[i] = i % 2 == 0 ? 1 : 3;
      points.v[i] += points.error[i] * noise(random);
    }
    const ExponentialProfile fit = fit_exponential(points, r_i);
    v0_covered += static_cast<int>(fit.v0.low <= 1 && 1 <= fit.v0.high);
    s_covered += static_cast<int>(fit.s.low <= width && width <= fit.s.high);
  }
  expect_measured(v0_covered, 0.95 * trials, 0.045 * trials);
  expect_measured(s_covered, 0.95 * trials, 0.045 * trials);
  RecordProperty("covered", std::to_string(v0_covered) + " and " + std::to_string(s_covered));
}

// A point far off but with a thousand times the error must not move the fit: its weight is 1e-6 of the
// others'.
TEST(ExponentialProfile, PointsCountByTheInverseSquareOfTheirError) {
  ProfilePoints points = exact_profile(1, 30);
  points.error = Eigen::ArrayXd::Constant(30, 1e-3);
  points.v[10] += 0.1;
  points.error[10] = 1;
  expect_measured(fit_exponential(points, r_i).v0.value, 1, 1e-6);
  points.error[10] = 1e-3;
  EXPECT_GT(std::abs(fit_exponential(points, r_i).v0.value - 1), 1e-4);
}

TEST(ExponentialProfile, WhatCannotBeFittedIsAFailedRun) {
  const auto kind_of = [](const ProfilePoints& points) {
    try {
      fit_exponential(points, r_i);
    } catch (const Error& error) {
      return error.kind();
    }
    return Error::Kind::bad_input;
  };
  EXPECT_EQ(kind_of(exact_profile(1, 2)), Error::Kind::run_failed);  // too few
  ProfilePoints growing = exact_profile(1, 20);
  growing.v = growing.v.reverse().eval();
  EXPECT_EQ(kind_of(growing), Error::Kind::run_failed);
  ProfilePoints still = exact_profile(0, 20);
  EXPECT_EQ(kind_of(still), Error::Kind::run_failed);
}

}  // namespace
}  // namespace mikromakro
