// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/branch_dyad.h"

#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

constexpr double singular = 1e-12;

}  // namespace

void add_branch_dyad(std::span<const DiscContact> contacts, std::span<double> sums) {
  for (const DiscContact& contact : contacts) {
    sums[0] += contact.branch[0] * contact.branch[0];
    sums[1] += contact.branch[0] * contact.branch[1];
    sums[2] += contact.branch[1] * contact.branch[1];
  }
}

Eigen::Matrix2d inverse_branch_dyad(std::span<const double> sums) {
  const double determinant = sums[0] * sums[2] - sums[1] * sums[1];
  const double largest = 0.5 * (sums[0] + sums[2] + std::hypot(sums[0] - sums[2], 2 * sums[1]));
  // The ratio of the singular values is determinant / largest^2; also false for 0/0 (no contacts).
  if (!(determinant / (largest * largest) >= singular))
    return Eigen::Matrix2d::Constant(std::numeric_limits<double>::quiet_NaN());
  return (Eigen::Matrix2d() << sums[2], -sums[1], -sums[1], sums[0]).finished() / determinant;
}

}  // namespace mikromakro
