// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/nonlinear_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Column column_of(const ColumnsOfField& field, Eigen::Index column) {
  return field.columns.empty() ? Column{field.name, "", "", ""}
                               : field.columns[static_cast<std::size_t>(column)];
}

bool is_direction(const ColumnsOfField& field, Eigen::Index column) {
  return column > 0 && column_of(field, column).period != 0 && column_of(field, column - 1).length;
}

// By how much frames are too few for this column: 1 or less if they suffice.
double frames_needed(const Eigen::ArrayXd& curvature, const Eigen::ArrayXd& error) {
  constexpr double most = 1.0 / 16, of_few = 8;
  std::vector<double> squares;
  for (Eigen::Index row = 0; row < error.size(); ++row)
    if (std::isfinite(error[row])) squares.push_back(std::pow(curvature[row] / error[row], 2));
  if (squares.empty()) return 0;
  // Not the mean: quotients bend without limit where their denominators vanish.
  const auto middle = squares.begin() + std::ssize(squares) / 2;
  std::nth_element(squares.begin(), middle, squares.end());
  return *middle / most * (1 + of_few / static_cast<double>(squares.size()));
}

// Of directions whose `length` has this error; returns how many lose theirs.
Eigen::Index correct_directions(const Eigen::ArrayXd& length, const Eigen::ArrayXd& of_length,
                                Eigen::Ref<Eigen::ArrayXd, 0, Eigen::InnerStride<>> error) {
  constexpr double least = 4, of_selected = 8;
  Eigen::Index lost = 0;
  for (Eigen::Index row = 0; row < error.size(); ++row) {
    if (!std::isfinite(error[row])) continue;
    const double ratio = length[row] / of_length[row];
    lost += ratio > least ? 0 : 1;
    error[row] = ratio > least ? error[row] * std::sqrt(1 + of_selected / (ratio * ratio)) : nan;
  }
  return lost;
}

}  // namespace

NonlinearErrors correct_nonlinear(const ColumnsOfField& field, const ConstRowsRef& values,
                                  const ConstRowsRef& curvature, RowsRef error) {
  constexpr double contained = 2;
  NonlinearErrors made;
  for (Eigen::Index column = 0; column < field.count; ++column) {
    if (is_direction(field, column)) {
      made.undirected += correct_directions(values.col(column - 1), error.col(column - 1), error.col(column));
      continue;
    }
    const Column of = column_of(field, column);
    const double needed = of.length ? 0 : frames_needed(curvature.col(column), error.col(column));
    if (needed > 1) made.curved.push_back({of.name, needed});
    for (Eigen::Index row = 0; row < error.rows(); ++row) {
      double& one = error(row, column);
      one = needed > 1 ? nan : std::hypot(one, contained * curvature(row, column));
    }
  }
  return made;
}

}  // namespace mikromakro
