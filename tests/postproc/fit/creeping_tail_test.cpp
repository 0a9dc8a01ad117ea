// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/creeping_tail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "measured_error.h"

namespace mikromakro {
namespace {

// v = exp(-x/s) up to `bend`, behind it with the length s_tail, times exp(noise).
RingProfile bent(Eigen::Index rings, double bend, double s, double s_tail, double noise = 0) {
  RingProfile profile;
  profile.r = Eigen::ArrayXd::LinSpaced(rings, 0.1, 0.1 + 0.003 * static_cast<double>(rings - 1));
  profile.v.resize(rings);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (Eigen::Index i = 0; i < rings; ++i) {
    const double x = profile.r[i] - 0.1;
    profile.v[i] =
        std::exp(-std::min(x, bend) / s - std::max(0.0, x - bend) / s_tail + noise * normal(random));
  }
  return profile;
}

TEST(CreepingTail, BeginsAtTheBend) {
  // Rings at 0, 3, ... 57 mm; the last before the bend at 31 mm is that at 30 mm.
  const CreepingTail tail = creeping_tail(bent(20, 0.031, 0.01, 0.05));
  ASSERT_TRUE(tail.found);
  expect_measured(tail.last_r, 0.13, 1e-15, "r");
  EXPECT_EQ(tail.rings, 9);
  expect_measured(tail.s / 0.05, 1, 1e-12, "s of the tail");
  EXPECT_GT(tail.evidence, 100);
}

// BIC: one line explains it; two would gain n log(sum1/sum2) of 3 log n.
TEST(CreepingTail, IsNotSeenInAnExponential) {
  EXPECT_FALSE(creeping_tail(bent(20, 1, 0.01, 0.01)).found);
  EXPECT_FALSE(creeping_tail(bent(40, 1, 0.01, 0.01, 0.1)).found);
}

TEST(CreepingTail, IsSeenInNoise) {
  const CreepingTail tail = creeping_tail(bent(40, 0.031, 0.01, 0.05, 0.1));
  ASSERT_TRUE(tail.found);
  // Behind the bend the lines part by 3 mm (1/10 - 1/50 per mm) = 0.24 per ring, 2.4 times the noise.
  expect_measured(tail.last_r, 0.13, 0.0061, "r");
}

// A profile that falls faster outside has no tail that creeps.
TEST(CreepingTail, FallsLessThanTheZone) {
  EXPECT_FALSE(creeping_tail(bent(20, 0.031, 0.05, 0.01)).found);
}

TEST(CreepingTail, HoldsRingsThatMoveTheOtherWay) {
  RingProfile profile = bent(20, 1, 0.01, 0.01);
  profile.v[15] *= -1;
  const CreepingTail tail = creeping_tail(profile);
  ASSERT_TRUE(tail.found);
  EXPECT_EQ(tail.rings, 5);
  EXPECT_EQ(tail.sign_from, 5);
  expect_measured(tail.last_r, 0.142, 1e-15, "r");
}

// Of profiles whose rings fluctuate by 0.25 v, neighbours with a correlation of 0.5.
struct Trials {
  int found = 0;
  std::vector<double> s;  // of log v up to the tail, sorted; 0.01 is right
};

double decay_length(const RingProfile& profile, double to) {
  FitWay way{FitOf::log_v};
  way.to = to;
  return fit_exponential(profile, 0.1, way).s;
}

Trials trials(double bend, double s_tail) {
  Trials trials;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    RingProfile profile = bent(20, bend, 0.01, s_tail);
    double noise = normal(random);
    for (double& v : profile.v) {
      v *= std::exp(0.25 * noise);
      noise = 0.5 * noise + std::sqrt(0.75) * normal(random);
    }
    const CreepingTail tail = creeping_tail(profile);
    trials.found += tail.found ? 1 : 0;
    trials.s.push_back(decay_length(profile, tail.found ? tail.last_r : 1));
  }
  std::sort(trials.s.begin(), trials.s.end());
  return trials;
}

// A tail that is not there is found now and then, since few rings tell little of their correlation; s hardly
// changes then.
TEST(CreepingTail, LeavesTheLengthOfAnExponential) {
  const Trials exponential = trials(1, 0.01);
  EXPECT_LT(exponential.found, 150);
  expect_measured(exponential.s[250] / 0.01, 1, 0.02, "median of s");
  const Trials creeping = trials(0.031, 0.05);
  EXPECT_GT(creeping.found, 480);
  expect_measured(creeping.s[250] / 0.01, 1, 0.05, "median of s, with a tail");
  RecordProperty("found_of_500", exponential.found);
}

TEST(CreepingTail, NeedsSevenRings) {
  EXPECT_TRUE(creeping_tail(bent(7, 0.0091, 0.01, 0.5)).found);
  EXPECT_FALSE(creeping_tail(bent(6, 0.0091, 0.01, 0.5)).found);
  EXPECT_FALSE(creeping_tail({}).found);
}

}  // namespace
}  // namespace mikromakro
