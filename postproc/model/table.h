// SPDX-License-Identifier: GPL-2.0-or-later
// A table of numbers with the meaning of its columns: what the averages give and the writers take.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mikromakro {

/// One column of the result.
struct Column {
  std::string name;
  std::string unit;
  std::string equation;  ///< where it is defined, e.g. "Latzel2001 Eq. 3"; "-" where nothing is to be said
  std::string text;
  double period = 0;  ///< of angles, in their unit: values that differ by it are the same; 0: of no angle
};

/// Numbers, row by row in memory.
using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Table {
  std::vector<Column> columns;
  Rows rows;
};

}  // namespace mikromakro
