// SPDX-License-Identifier: GPL-2.0-or-later
// Vectors and tensors among the columns of a table, in Cartesian components.
#pragma once

#include <array>
#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// A vector (two columns) or a tensor (four of the plane; two, zx and zy, of couple stresses and curvatures).
struct CartesianPart {
  enum class Kind { vector, tensor, out_of_plane };

  std::string name;  ///< the columns' names without `_r`, `_rr`, `_zr`, `_x` ...
  Kind kind = Kind::vector;
  bool polar = false;       ///< whether its columns are components along e_r and e_phi
  Eigen::Index column = 0;  ///< the first of them, which stand side by side

  std::size_t components() const { return kind == Kind::vector ? 3 : 9; }
  /// x, y, z, or xx, xy, xz, yx, ... of one row; zero out of the plane. Polar components are rotated to the
  /// direction `angle` of e_r (rad from x): T_ij = R_ia T_ab R_jb with R = (e_r, e_phi).
  std::vector<double> at(const Rows& rows, Eigen::Index row, double angle) const;
};

/// All of them, in the order of the columns, whose names no column has.
std::vector<CartesianPart> cartesian_parts(const std::vector<Column>& columns);

}  // namespace mikromakro
