// SPDX-License-Identifier: GPL-2.0-or-later
// A table of numbers with the meaning of its columns: output of the averages, input of the writers.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mikromakro {

/// One column of the result.
struct Column {
  std::string name;
  std::string unit;
  std::string equation;  ///< where it is defined, e.g. "Latzel2001 Eq. 3"; "-" if there is nothing to cite
  std::string text;
  double period = 0;  ///< period of angles, in the column's unit; 0: not an angle
  /// Whether it contains the length of a vector, as a deviator is; the length that belongs to an angle is the
  /// column before it.
  bool length = false;
};

/// Numbers, row-major.
using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Table {
  std::vector<Column> columns;
  Rows rows;
};

}  // namespace mikromakro
