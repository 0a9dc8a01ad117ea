// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

constexpr double degree = 180 / std::numbers::pi;
constexpr double of_degrees = 1e-12;  // rounding of angles of order 10

// Symmetric parts have the principal values mean +- dev/2 (Latzel2001 Bild 7 b, 8 b); directions from the
// eigenvectors.

// V sigma = (-20, 0; -12, -4) as in stiffness_test.cpp: its symmetric part (-20, -6; -6, -4) has -12 +- 10;
// the largest compression is along (3, 1).
TEST(StressAxes, AreThoseOfTheLargestCompression) {
  const Frame frame = disc_between_walls({{{1, 0}, {-10, -6}}, {{0, 1}, {0, -2}}});
  const RingAverage average(frame, whole_ring({"stress_axes"}));
  expect_measured(average.at("tr_sigma") * ring_volume, -24, 10 * few_roundings);
  expect_measured(average.at("dev_sigma") * ring_volume, 20, 10 * few_roundings);
  expect_measured(average.at("angle_sigma"), degree * std::atan(1.0 / 3), of_degrees);
  expect_measured(average.at("sigma_major") * ring_volume, -22, 10 * few_roundings);
  expect_measured(average.at("sigma_minor") * ring_volume, -2, 10 * few_roundings);
}

// eps = (-0.1, 0.0375; 0, -0.05) as in elastic_strain_test.cpp: dev = sqrt(0.05^2 + 0.0375^2) = 0.0625, the
// largest compression along (3, -1).
TEST(StrainAxes, AreThoseOfTheLargestCompression) {
  const Frame frame = disc_between_walls({{{1, 0}, {0, 0}, 0.2}, {{0.6, 0.8}, {0, 0}, 0.1}});
  const RingAverage average(frame, whole_ring({"strain_axes"}));
  expect_measured(average.at("tr_eps"), -0.15, few_roundings);
  expect_measured(average.at("dev_eps"), 0.0625, few_roundings);
  expect_measured(average.at("angle_eps"), -degree * std::atan(1.0 / 3), of_degrees);
  expect_measured(average.at("eps_major"), -0.10625, few_roundings);
  expect_measured(average.at("eps_minor"), -0.04375, few_roundings);
}

// F = 0.01 (1.36, 0.48; 0.48, 0.64) as in fabric_test.cpp: dev = 0.01 sqrt(0.72^2 + 0.96^2), the largest
// value half-way between the contacts at 0 and at atan(4/3) = 2 atan(1/2).
TEST(FabricAxes, AreThoseOfTheLargestValue) {
  const Frame frame = disc_between_walls({{{1, 0}}, {{0.6, 0.8}}});
  const RingAverage average(frame, whole_ring({"fabric_axes"}));
  expect_measured(average.at("tr_F"), 0.02, few_roundings);
  expect_measured(average.at("dev_F"), 0.012, few_roundings);
  expect_measured(average.at("angle_F"), degree * std::atan(0.5), of_degrees);
  expect_measured(average.at("F_major"), 0.016, few_roundings);
  expect_measured(average.at("F_minor"), 0.004, few_roundings);
}

}  // namespace
}  // namespace mikromakro
