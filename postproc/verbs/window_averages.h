// SPDX-License-Identifier: GPL-2.0-or-later
// `mikromakro average` as a function of time.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "averaging/window_rows.h"
#include "io/frames/frame_stream.h"
#include "io/tables/series_table.h"
#include "options/average_options.h"
#include "options/series_outputs.h"
#include "options/window_options.h"

namespace mikromakro {

/// Writes the windows to the output files while the frames are read. On rank 0.
class WindowAverages {
 public:
  /// Creates the files. `source.walls` are the walls in the table. `keeps_table`: write() returns it, and
  /// nothing goes to standard output.
  WindowAverages(const AverageOptions& options, const WindowOptions& windows, const Averager& averager,
                 const FrameSource& source, bool keeps_table);

  void add(const FrameSums& frame) { windows_.add(frame); }

  /// Completes the files, below `lines`; `averaged` is the average of all frames. Throws if no window is
  /// full. Returns the table, without rows unless it is kept.
  AveragedTable write(const Averaged& averaged, Preamble lines);

 private:
  void take(const Window& window);
  void describe_errors(Preamble& lines) const;

  const AverageOptions& options_;
  const WindowOptions& rule_;
  const Averager& averager_;
  WindowRows rows_;
  SeriesOutputs outputs_;
  std::optional<SeriesTable> table_;
  Windows windows_;
  std::map<std::string, std::int64_t> with_errors_;  // windows by field
};

}  // namespace mikromakro
