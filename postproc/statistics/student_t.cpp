// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/student_t.h"

#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace mikromakro {
namespace {

double two_sided_tail(double t, double freedom) {
  const double x = freedom / (freedom + t * t);
  return Eigen::numext::betainc(0.5 * freedom, 0.5, x);
}

}  // namespace

double student_t(double confidence, double freedom) {
  const double tail = 1 - confidence;
  double low = 0;
  double high = 1;
  while (two_sided_tail(high, freedom) > tail) high *= 2;
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (two_sided_tail(middle, freedom) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace mikromakro
