// SPDX-License-Identifier: GPL-2.0-or-later
// Balance of momentum over the cells of a grid.
#pragma once

#include <vector>

#include "model/table.h"

namespace mikromakro {

/// What is left of the forces on one cell.
struct CellBalance {
  double x = 0;  ///< middle of the cell, m
  double y = 0;
  Eigen::Vector2d left;  ///< div sigma + t, N/m^3
};

/// d sigma_xx/dx + d sigma_xy/dy + t_x and d sigma_yx/dx + d sigma_yy/dy + t_y of the cells that have all
/// four neighbours, from a table of `mikromakro average --grid` with `columns` cells in each row and the
/// fields stress and wall_force_density. Slopes are differences of the neighbours over twice the cell's side.
/// Where the discs rest and the weight is a kernel, what is left goes to 0 with the square of side over
/// width.
std::vector<CellBalance> cell_balances(const Table& table, int columns);

/// Largest |left| times the longer side of a cell over the mean pressure -tr sigma/2 of all cells: the force
/// on a cell beside that on its side. nan where no cell has four neighbours.
double momentum_deviation(const Table& table, int columns);

}  // namespace mikromakro
