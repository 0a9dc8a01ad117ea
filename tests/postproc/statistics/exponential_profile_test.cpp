// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/exponential_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double r_i = 0.1032;
constexpr double width = 0.0127;  // the paper's s

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
    EXPECT_EQ(fit.used.size(), 60U);
    EXPECT_LT(fit.residual_rms, 1e-12 * std::abs(v0));
  }
}

TEST(ExponentialProfile, LogarithmsOfExactDataGiveBackTheirParameters) {
  for (const double v0 : {6.66e-3, -6.66e-3}) {
    ProfilePoints points = exact_profile(v0, 60);
    for (const bool weighted : {false, true}) {
      if (weighted) points.error = 0.1 * points.v.abs() + 1e-6;
      const ExponentialProfile fit = fit_exponential(points, r_i, FitOf::log_v);
      expect_measured(fit.v0 / v0, 1, 1e-10);
      expect_measured(fit.s / width, 1, 1e-10);
    }
  }
}

// log v = 0, -1, -1, -3 at x = 0, 1, 2, 3: the line through them is 0.1 - 0.9 x.
TEST(ExponentialProfile, LogarithmsAreFittedByAStraightLine) {
  ProfilePoints points;
  points.r = Eigen::Array4d(1, 2, 3, 4);
  points.v = Eigen::Array4d(0, -1, -1, -3).exp();
  const ExponentialProfile fit = fit_exponential(points, 1, FitOf::log_v);
  expect_measured(fit.v0, std::exp(0.1), 1e-12);
  expect_measured(fit.s, 1 / 0.9, 1e-12);
}

// Central differences with a step of 1e-4, of v0 or of v: their own error is of the order 1e-8, of Gauss and
// Newton that of the residuals, which are 0 here. Steps of 1e-4 v in the tail of a fit of v would be lost in
// the rounding of v0.
TEST(ExponentialProfile, ChangeOfTheParametersIsThatOfTheFit) {
  for (const FitOf of : {FitOf::v, FitOf::log_v}) {
    for (const bool weighted : {false, true}) {
      ProfilePoints points = exact_profile(1, 12);
      if (weighted) points.error = 0.1 + points.v;
      const ExponentialProfile fit = fit_exponential(points, r_i, of);
      for (const Eigen::Index i : {0, 5, 11}) {
        const double step = of == FitOf::v ? 1e-4 : 1e-4 * points.v[i];
        ProfilePoints more = points, less = points;
        more.v[i] += step;
        less.v[i] -= step;
        const ExponentialProfile high = fit_exponential(more, r_i, of), low = fit_exponential(less, r_i, of);
        const double of_v0 = (high.v0 - low.v0) / (2 * step), of_s = (high.s - low.s) / (2 * step);
        // Fits end at 1e-8 of their parameters, at worst 1e-4 of such a difference; Eigen 3.4 and 5 end at
        // other places, 1e-6 apart.
        constexpr double end_of_fits = 1e-5;
        expect_measured(fit.change(0, i) / of_v0, 1, end_of_fits);
        expect_measured(fit.change(1, i) / of_s, 1, end_of_fits);
      }
    }
  }
}

TEST(ExponentialProfile, RingsWithoutValueAreLeftOut) {
  ProfilePoints points = exact_profile(1, 20);
  points.v[3] = std::nan("");
  const ExponentialProfile fit = fit_exponential(points, r_i);
  EXPECT_EQ(fit.used.size(), 19U);
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
  ProfilePoints signs = exact_profile(1, 20);
  signs.v[12] = -1e-3;
  EXPECT_THROW(fit_exponential(signs, r_i, FitOf::log_v), Error);
  EXPECT_NO_THROW(fit_exponential(signs, r_i));
  // exp(-20 x): two parts in 10^9 are left in the second ring.
  const Eigen::Array4d x(0, 1, 2, 3);
  EXPECT_EQ(kind_of({r_i + x, (-20 * x).exp(), {}}), Error::Kind::run_failed);
  EXPECT_NO_THROW(fit_exponential({r_i + x, (-10 * x).exp(), {}}, r_i));
  ProfilePoints still = exact_profile(0, 20);
  EXPECT_EQ(kind_of(still), Error::Kind::run_failed);
}

}  // namespace
}  // namespace mikromakro
