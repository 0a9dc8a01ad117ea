// SPDX-License-Identifier: GPL-2.0-or-later
// Averages where they are hard: next to nothing of a disc in a ring, a million frames. Criteria are in
// docs/results/stability.md.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "averaging/time_average.h"
#include "averaging/volumes/disc_circle_area.h"
#include "io/tables/csv_reader.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

/// The lens as textbooks have it.
double textbook_area(double d, double R) {
  const double alpha = std::acos((d * d + 1 - R * R) / (2 * d)),
               beta = std::acos((d * d + R * R - 1) / (2 * d * R));
  return alpha + R * R * beta - std::sqrt((-d + 1 + R) * (d + 1 - R) * (d - 1 + R) * (d + 1 + R)) / 2;
}

// 60 digits; 1e-13 of the disc's area is what is promised. The textbook's formula is off by more than that,
// where it is a number at all.
TEST(DiscCircleArea, SliversAgreeWithSixtyDigits) {
  const CsvTable table(TEST_DATA "/reference/slivers.csv");
  const auto d = table.column("d"), R = table.column("R"), fraction = table.column("fraction");
  ASSERT_EQ(table.rows(), 80);
  double textbook = 0;
  for (int k = 0; k < table.rows(); ++k) {
    expect_measured(disc_circle_area(d[k], 1, R[k]) / std::numbers::pi, fraction[k], 1e-13);
    textbook = std::fmax(textbook, std::abs(textbook_area(d[k], R[k]) / std::numbers::pi - fraction[k]));
  }
  std::printf("the textbook's formula is off by %.1e\n", textbook);
  EXPECT_GT(textbook, 1e-13);
}

// Sums that are equal, that grow, that alternate: means against closed forms. A plain sum of a million is off
// by up to 1e-10 of the mean; 2 ulp are left by the division and the last addition.
TEST(TimeAverage, OfAMillionFramesLosesNoPrecision) {
  constexpr int frames = 1000000;
  TimeAverage average;
  double plain = 0;
  for (int k = 0; k < frames; ++k) {
    Rows row(1, 3);
    row << 0.1, 1e-3 * k, (k % 2 == 0 ? 1 : -1) * 1e3 + 1e-3;
    average.add(row);
    plain += 0.1;
  }
  const Rows mean = average.mean();
  expect_measured(mean(0, 0) / 0.1, 1, 4.5e-16);
  expect_measured(mean(0, 1) / (1e-3 * (frames - 1) / 2), 1, 4.5e-16);
  // Terms of 1e3 are rounded to 1e-13 before they are added.
  expect_measured(mean(0, 2) / 1e-3, 1, 1e-10);
  std::printf("a plain sum would be off by %.1e\n", plain / frames / 0.1 - 1);
}

}  // namespace
}  // namespace mikromakro
