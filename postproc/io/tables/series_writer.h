// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of windows, written window by window.
#pragma once

#include "io/tables/csv_writer.h"

namespace mikromakro {

/// Columns of a table that has a row for each volume of each window.
struct SeriesColumns {
  std::vector<Column> of_window;  ///< the same in all rows of a window: step, time, ...
  std::vector<Column> of_volume;  ///< the same in all windows: radii, ...
  std::vector<Column> values;     ///< everything else
  Rows volumes;                   ///< volumes x of_volume

  /// In the order of a row.
  std::vector<Column> all() const;
};

/// Holds one window at most.
class SeriesWriter {
 public:
  SeriesWriter() = default;
  SeriesWriter(const SeriesWriter&) = delete;
  SeriesWriter& operator=(const SeriesWriter&) = delete;
  virtual ~SeriesWriter() = default;

  /// One number for each column of the window; `values`: volumes x values.
  virtual void add(const Eigen::ArrayXd& window, const Rows& values) = 0;
  /// Completes the file; the lines above the table are known only at the end.
  virtual void finish(const Preamble& preamble) = 0;
};

}  // namespace mikromakro
