// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/stiffness.h"

#include <limits>

#include "fields/tensor_parts.h"

namespace mikromakro {
namespace {

// `denominator` is an invariant (trace or deviator) of `strain`.
double quotient(double numerator, double denominator, TensorRow strain) {
  return is_rounding(denominator, strain) ? std::numeric_limits<double>::quiet_NaN()
                                          : numerator / denominator;
}

}  // namespace

std::vector<Column> Stiffness::columns(const Axes& /*axes*/) const {
  const std::string unit = normal_stiffness_ > 0 ? "k_n/h" : "Pa";
  return {{"E", unit, "Latzel2001 Bild 9", "stiffness tr sigma/tr eps"},
          {"G", unit, "Latzel2001 Bild 10", "shear modulus dev sigma/dev eps"}};
}

void Stiffness::solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const {
  const double unit = normal_stiffness_ > 0 ? normal_stiffness_ / volumes.height : 1.0;
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    const TensorRow stress = numbers_of(numbers, row, 0, 4);
    const TensorRow strain = numbers_of(numbers, row, 4, 4);
    columns(row, 0) = quotient(trace(stress), trace(strain), strain) / unit;
    columns(row, 1) = quotient(deviator(stress), deviator(strain), strain) / unit;
  }
}

}  // namespace mikromakro
