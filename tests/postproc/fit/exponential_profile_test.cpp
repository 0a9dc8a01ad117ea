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
    expect_measured(fit.v0 / v0, 1, 1e-10);
    expect_measured(fit.s / width, 1, 1e-10);
    EXPECT_EQ(fit.used.size(), 60);
    EXPECT_LT(fit.residual_rms, 1e-12 * std::abs(v0));
  }
}

TEST(ExponentialProfile, RingsWithoutValueAreLeftOut) {
  ProfilePoints points = exact_profile(1, 20);
  points.v[3] = std::nan("");
  const ExponentialProfile fit = fit_exponential(points, r_i);
  EXPECT_EQ(fit.used.size(), 19);
  expect_measured(fit.s / width, 1, 1e-10);
}

// A point far off but with a thousand times the error must not move the fit: its weight is 1e-6 of the
// others'.
TEST(ExponentialProfile, PointsCountByTheInverseSquareOfTheirError) {
  ProfilePoints points = exact_profile(1, 30);
  points.error = Eigen::ArrayXd::Constant(30, 1e-3);
  points.v[10] += 0.1;
  points.error[10] = 1;
  expect_measured(fit_exponential(points, r_i).v0, 1, 1e-6);
  points.error[10] = 1e-3;
  EXPECT_GT(std::abs(fit_exponential(points, r_i).v0 - 1), 1e-4);
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
