// SPDX-License-Identifier: GPL-2.0-or-later
// The table of windows in memory.
#pragma once

#include <vector>

#include "io/tables/series_writer.h"

namespace mikromakro {

/// Holds all windows, one row for each volume of each.
class SeriesTable : public SeriesWriter {
 public:
  explicit SeriesTable(SeriesColumns columns) : columns_(std::move(columns)) {}

  void add(const Eigen::ArrayXd& window, const Rows& values) override;
  void finish(const Preamble& /*preamble*/) override {}
  Table table() const;

 private:
  SeriesColumns columns_;
  std::vector<double> numbers_;  // row by row
};

}  // namespace mikromakro
