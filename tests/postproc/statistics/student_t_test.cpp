// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/student_t.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measured_error.h"

namespace mikromakro {
namespace {

// Closed forms: 1 degree of freedom is the Cauchy distribution, t = tan(pi c/2); 2 degrees: t = c sqrt(2/(1 -
// c^2)). The incomplete beta function is good to about 1e-13, its inverse near c = 0.95 to ten times that.
TEST(StudentT, OneAndTwoDegreesOfFreedomHaveClosedForms) {
  expect_measured(student_t(0.95, 1) / std::tan(0.475 * std::numbers::pi), 1, 1e-11);
  expect_measured(student_t(0.95, 2) / (0.95 * std::sqrt(2 / (1 - 0.95 * 0.95))), 1, 1e-11);
}

// Printed tables: 2.2281 (10), 2.0003 (60); five digits.
TEST(StudentT, AgreesWithPrintedTables) {
  expect_measured(student_t(0.95, 10), 2.2281, 5e-5);
  expect_measured(student_t(0.95, 60), 2.0003, 5e-5);
}

}  // namespace
}  // namespace mikromakro
