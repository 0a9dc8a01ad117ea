// SPDX-License-Identifier: GPL-2.0-or-later
// Momentum balance of the cells of a grid.
#pragma once

#include <vector>

#include "model/table.h"

namespace mikromakro {

/// Residual force on one cell.
struct CellBalance {
  double x = 0;  ///< centre of the cell, m
  double y = 0;
  Eigen::Vector2d left;  ///< div sigma + t, N/m^3
};

/// d sigma_xx/dx + d sigma_xy/dy + t_x and d sigma_yx/dx + d sigma_yy/dy + t_y of the cells with all four
/// neighbours, from a table of `mikromakro average --grid` with `columns` cells per row and the fields stress
/// and wall_force_density. Derivatives are central differences. If the discs are at rest and the weight is a
/// kernel, the residual vanishes as (cell side/width)^2.
std::vector<CellBalance> cell_balances(const Table& table, int columns);

/// Largest |left| times the longer cell side, relative to the mean pressure -tr sigma/2 of all cells: the
/// residual force on a cell relative to the force on one of its sides. nan if no cell has four neighbours.
double momentum_deviation(const Table& table, int columns);

}  // namespace mikromakro
