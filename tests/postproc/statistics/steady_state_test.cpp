// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/steady_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

namespace mikromakro {
namespace {

using Drift = std::function<double(double)>;  // of the time from 0 to 1, in standard deviations

// x_i = rho x_(i-1) + noise of variance 1 - rho^2, and a drift.
std::vector<double> series_of(int count, double rho, const Drift& drift, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  std::vector<double> series;
  double x = noise(random);
  for (int i = 0; i < count; ++i) {
    series.push_back(x + drift(static_cast<double>(i) / count));
    x = rho * x + std::sqrt(1 - rho * rho) * noise(random);
  }
  return series;
}

struct Trials {
  double steady = 0, begin = 0;  // part of the trials, mean over these as a part of the series
};

Trials trials(int count, double rho, const Drift& drift) {
  constexpr int number = 1000;
  Trials result;
  for (unsigned seed = 0; seed < number; ++seed) {
    const SteadyState state = steady_state(series_of(count, rho, drift, seed));
    if (!state.steady()) continue;
    result.steady += 1.0 / number;
    result.begin += static_cast<double>(state.begin) / count;
  }
  result.begin /= number * result.steady;
  return result;
}

double none(double) {
  return 0;
}

// By hand: batches 8 0 0 0 0 0 0 0; MSER(0) = (49 + 7)/64, MSER(1) = 0.
TEST(SteadyState, CutsAJump) {
  std::vector<double> series(40, 0);
  for (std::size_t i = 0; i < 5; ++i) series[i] = 8;
  const SteadyState state = steady_state(series);
  EXPECT_EQ(state.begin, 5);
  EXPECT_TRUE(state.steady());
  EXPECT_EQ(state.change, 0);
}

TEST(SteadyState, OfEqualValuesBeginsAtOnce) {
  const SteadyState state = steady_state(std::vector<double>(43, 0.1));
  EXPECT_EQ(state.begin, 0);
  EXPECT_TRUE(state.steady());
}

// One in twenty is told from a steady one at first, and few of these to the end.
TEST(SteadyState, KeepsSteadySeries) {
  EXPECT_GT(trials(200, 0, none).steady, 0.95);
  EXPECT_GT(trials(1000, 0.8, none).steady, 0.95);
  EXPECT_LT(trials(200, 0, none).begin, 0.1);
}

// 5 exp(-10 t) is 1.1 standard deviations at t = 0.15, and 0.15 at t = 0.35.
TEST(SteadyState, CutsATransient) {
  const Trials transient = trials(500, 0.5, [](double t) { return 5 * std::exp(-10 * t); });
  EXPECT_GT(transient.steady, 0.8);
  EXPECT_NEAR(transient.begin, 0.25, 0.1);
}

// The rest is half of the series or more, and changes by 1.5 or more: with 250 values of standard deviation 1
// 6.8 errors, with 500 of 2 tau = 3 5.6.
TEST(SteadyState, RefusesADriftToTheEnd) {
  const Drift drift = [](double t) { return 3 * t; };
  EXPECT_LT(trials(500, 0, drift).steady, 0.01);
  EXPECT_LT(trials(1000, 0.5, drift).steady, 0.02);
  const SteadyState random_walk = steady_state(series_of(
      200, 0.9999, [](double t) { return 3 * t; }, 1));
  EXPECT_FALSE(random_walk.steady());
}

TEST(SteadyState, NeedsFortyValues) {
  EXPECT_THROW(steady_state(std::vector<double>(39, 1)), std::invalid_argument);
  EXPECT_NO_THROW(steady_state(std::vector<double>(40, 1)));
}

}  // namespace
}  // namespace mikromakro
