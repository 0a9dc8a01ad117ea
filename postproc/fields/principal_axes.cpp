// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/principal_axes.h"

#include <fmt/format.h>

#include "fields/tensor_parts.h"

namespace mikromakro {

std::vector<Column> PrincipalAxes::columns(const Axes& axes) const {
  const std::string symbol(tensor_.symbol);
  const std::string unit(tensor_.unit);
  const std::string major = tensor_.compression_negative ? "largest compression" : "largest value";
  return {
      {"tr_" + symbol, unit, "-", "trace"},
      {"dev_" + symbol, unit, "-", "largest minus smallest principal value", 0, true},
      {"angle_" + symbol, "degree", "-",
       fmt::format("direction of the {}, counter-clockwise from e_{}, in (-90, 90]", major, axes[0]), 180},
      {symbol + "_major", unit, "-", "principal value of the " + major, 0, true},
      {symbol + "_minor", unit, "-", "the other principal value", 0, true}};
}

void PrincipalAxes::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers, RowsRef columns) const {
  const double side = tensor_.compression_negative ? -1 : 1;
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    const TensorRow tensor = numbers_of(numbers, row, 0, 4);
    const double mean = 0.5 * trace(tensor);
    const double half = 0.5 * side * deviator(tensor);
    columns.row(row) << trace(tensor), deviator(tensor),
        principal_angle(tensor, tensor_.compression_negative), mean + half, mean - half;
  }
}

}  // namespace mikromakro
