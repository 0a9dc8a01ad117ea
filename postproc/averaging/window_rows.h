// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of the table of windows.
#pragma once

#include "averaging/averager.h"
#include "averaging/block_errors.h"
#include "averaging/windows.h"
#include "io/tables/series_writer.h"
#include "model/wall_numbers.h"

namespace mikromakro {

/// Which columns the table has besides those of the averager.
struct WindowColumns {
  bool errors = true;                   ///< standard errors of each window, as in a table of all frames
  bool runs = false;                    ///< the run of each window, where there are several
  std::vector<WallNumbers> walls = {};  ///< means of these; FrameSums::walls holds their numbers
};

/// The columns step, time, step_first and step_last, then run (from 1) if `runs`; and their numbers.
std::vector<Column> window_columns(bool runs);
Eigen::ArrayXd window_numbers(const Window& window, bool runs);

/// Computes the rows of a window: step, time, step_first, step_last, then run (from 1) and numbers of walls,
/// if any; then the columns of Averager::solve() and append_errors().
class WindowRows {
 public:
  WindowRows(const Averager& averager, WindowColumns columns);

  SeriesColumns columns() const;

  /// `values`: volumes x SeriesColumns::values.
  struct Of {
    Eigen::ArrayXd numbers;
    Rows values;
    BlockErrors errors;  ///< empty unless they are in the table
  };
  Of of(const Window& window) const;

 private:
  const Averager& averager_;
  WindowColumns columns_;
};

}  // namespace mikromakro
