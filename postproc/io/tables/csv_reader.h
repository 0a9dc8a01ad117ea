// SPDX-License-Identifier: GPL-2.0-or-later
// Reads comma-separated tables as written by `mikromakro average`.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "model/error.h"

namespace mikromakro {

/// A table of numbers with column names.
class CsvTable {
 public:
  /// Reads `file`: leading lines with '#', a line of names, rows of numbers (nan allowed). Throws on missing
  /// or duplicate names, a row with a different number of columns, and a value that is not a number.
  explicit CsvTable(const std::string& file);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  Eigen::Index rows() const { return values_.rows(); }
  bool has(std::string_view name) const;
  /// Throws if there is no such column.
  Eigen::ArrayXd column(std::string_view name) const;
  /// The unit of a column as given in the lines above the table, empty if not given.
  std::string unit(std::string_view name) const;
  /// Some of its rows, with the same names and lines above.
  CsvTable part(Eigen::Index begin, Eigen::Index rows) const;
  /// Location of a row (from 0) in the file.
  Place row_place(Eigen::Index row) const { return {file_, row_lines_[static_cast<std::size_t>(row)]}; }
  /// Text of the lines with '#'.
  const std::vector<std::string>& comments() const { return comments_; }

 private:
  std::string file_;
  std::int64_t names_line_ = 0;
  std::vector<std::int64_t> row_lines_;
  std::vector<std::string> names_;
  std::vector<std::string> comments_;
  Eigen::ArrayXXd values_;
};

}  // namespace mikromakro
