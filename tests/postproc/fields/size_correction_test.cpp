// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "measured_error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;  // sums of 2000 terms

// g2 of discs of the given radii, which need not touch.
double size_correction(const std::vector<double>& radii, const std::string& column) {
  RingSetup setup;
  setup.edges = {0, 1000};
  setup.fields = {"g2"};
  Frame frame;
  for (const double radius : radii)
    frame.particles.push_back(make_disc(static_cast<int>(frame.particles.size()) + 1, {20, 0}, radius));
  return RingAverage(frame, setup).at(column);
}

// Radii in the middle of 2000 equal parts of an interval: the midpoint rule, good to 1e-7.
std::vector<double> uniform_radii(double smallest, double largest) {
  constexpr int parts = 2000;
  std::vector<double> radii;
  radii.reserve(parts);
  for (int i = 0; i < parts; ++i) radii.push_back(smallest + (largest - smallest) * (i + 0.5) / parts);
  return radii;
}

// Latzel2001 Eq. 10: <a^2/Omega>/(<a^2><1/Omega>). Values that docs/conventions.md quotes, to their last
// digit.
TEST(SizeCorrection, HasItsValuesForKnownDistributions) {
  expect_measured(size_correction({3, 3, 3}, "g2"), 1, rounding);
  EXPECT_NEAR(size_correction({1, 3}, "g2"), 1.2231, 5e-5);
  EXPECT_NEAR(size_correction(uniform_radii(0.8, 1.2), "g2"), 1.0145, 5e-5);
  EXPECT_NEAR(size_correction(uniform_radii(0.5, 1.5), "g2"), 1.085, 5e-4);
}

// Radii 1 and 3: <a> = 2, <a^2> = 5, <a^3> = 14: 1 + sqrt(3)/pi (1.4 - 1).
TEST(SizeCorrection, LinearFormAsWorkedByHand) {
  expect_measured(size_correction({1, 3}, "g2_linear"), 1 + std::numbers::sqrt3 / std::numbers::pi * 0.4,
                  rounding);
}

}  // namespace
}  // namespace mikromakro
