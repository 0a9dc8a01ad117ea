// SPDX-License-Identifier: GPL-2.0-or-later
// `mikromakro average` as a function of time.
#pragma once

#include <map>
#include <string>

#include "averaging/window_rows.h"
#include "io/frames/frame_stream.h"
#include "options/average_options.h"
#include "options/series_outputs.h"
#include "options/window_options.h"

namespace mikromakro {

/// Writes the windows to the output files while the frames are read. On rank 0.
class WindowAverages {
 public:
  /// Creates the files. `source.walls` are the walls in the table.
  WindowAverages(const AverageOptions& options, const WindowOptions& windows, const Averager& averager,
                 const FrameSource& source);

  void add(const FrameSums& frame) { windows_.add(frame); }

  /// Completes the files, below `lines`; `averaged` is the average of all frames. Throws if no window is
  /// full.
  void write(const Averaged& averaged, Preamble lines);

 private:
  void take(const Window& window);
  void describe_errors(Preamble& lines) const;

  const AverageOptions& options_;
  const WindowOptions& rule_;
  const Averager& averager_;
  WindowRows rows_;
  SeriesOutputs outputs_;
  Windows windows_;
  std::map<std::string, std::int64_t> with_errors_;  // windows by field
};

}  // namespace mikromakro
