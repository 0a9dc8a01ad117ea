// SPDX-License-Identifier: GPL-2.0-or-later
// Tables in comma-separated text, as `mikromakro average` writes them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "model/error.h"

namespace mikromakro {

/// A table of numbers by column names.
class CsvTable {
 public:
  /// Reads `file`: lines with '#' first, a line of names, rows of numbers (nan allowed).
  /// Throws: no names, names twice, a row with another number of columns, a value that is no number.
  explicit CsvTable(const std::string& file);

  const std::string& file() const { return file_; }
  const std::vector<std::string>& names() const { return names_; }
  Eigen::Index rows() const { return values_.rows(); }
  bool has(std::string_view name) const;
  /// Throws when there is no such column.
  Eigen::ArrayXd column(std::string_view name) const;
  /// The unit that the lines above the table tell of a column, empty where they do not.
  std::string unit(std::string_view name) const;
  /// Where a row (from 0) stands in the file.
  Place row_place(Eigen::Index row) const { return {file_, row_lines_[static_cast<std::size_t>(row)]}; }
  /// Lines with '#', without it.
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
