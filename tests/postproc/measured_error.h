// SPDX-License-Identifier: GPL-2.0-or-later
// EXPECT_NEAR that also notes the largest error of the test, for docs/validation.md (--gtest_output=json:FILE
// shows it).
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace mikromakro {

inline void expect_measured(double value, double expected, double tolerance, const std::string& what = {}) {
  static std::string test;
  static double worst = 0;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(info->test_suite_name()) + "." + info->name();
  if (name != test) worst = 0;
  test = name;
  EXPECT_NEAR(value, expected, tolerance) << what;
  worst = std::fmax(worst, std::abs(value - expected));
  testing::Test::RecordProperty("worst_error", fmt::format("{:.1e}", worst));
}

}  // namespace mikromakro
