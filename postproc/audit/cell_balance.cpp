// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/cell_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "audit/table_column.h"

namespace mikromakro {
namespace {

struct Side {
  double x;
  double y;
};
Side side_of(const Table& table) {
  return {column_of(table, "x_max")[0] - column_of(table, "x_min")[0],
          column_of(table, "y_max")[0] - column_of(table, "y_min")[0]};
}

}  // namespace

std::vector<CellBalance> cell_balances(const Table& table, int columns) {
  const Eigen::ArrayXd x = column_of(table, "x");
  const Eigen::ArrayXd y = column_of(table, "y");
  const Eigen::ArrayXd xx = column_of(table, "sigma_xx");
  const Eigen::ArrayXd xy = column_of(table, "sigma_xy");
  const Eigen::ArrayXd yx = column_of(table, "sigma_yx");
  const Eigen::ArrayXd yy = column_of(table, "sigma_yy");
  const Eigen::ArrayXd t_x = column_of(table, "wall_force_density_x");
  const Eigen::ArrayXd t_y = column_of(table, "wall_force_density_y");
  const Side side = side_of(table);
  const auto along_x = [&](const Eigen::ArrayXd& of, Eigen::Index cell) {
    return (of[cell + 1] - of[cell - 1]) / (2 * side.x);
  };
  const auto along_y = [&](const Eigen::ArrayXd& of, Eigen::Index cell) {
    return (of[cell + columns] - of[cell - columns]) / (2 * side.y);
  };
  std::vector<CellBalance> cells;
  for (Eigen::Index cell = columns; cell + columns < x.size(); ++cell) {
    const Eigen::Index column = cell % columns;
    if (column == 0 || column == columns - 1) continue;
    cells.push_back({x[cell],
                     y[cell],
                     {along_x(xx, cell) + along_y(xy, cell) + t_x[cell],
                      along_x(yx, cell) + along_y(yy, cell) + t_y[cell]}});
  }
  return cells;
}

double momentum_deviation(const Table& table, int columns) {
  const std::vector<CellBalance> cells = cell_balances(table, columns);
  if (cells.empty()) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (const CellBalance& cell : cells) largest = std::max(largest, cell.left.norm());
  const double pressure =
      std::abs(0.5 * (column_of(table, "sigma_xx") + column_of(table, "sigma_yy")).mean());
  const Side side = side_of(table);
  return largest * std::max(side.x, side.y) / pressure;
}

}  // namespace mikromakro
