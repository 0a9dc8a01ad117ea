// SPDX-License-Identifier: GPL-2.0-or-later
// The snapshot file of a run, appended frame by frame and readable at any time.
#pragma once

#include <string>

#include "io/frames/frame_format.h"
#include "io/snapshot/snapshot_parameters.h"

namespace mikromakro {

/// Appends frames to one HDF5 file in the layout of snapshot_layout.h. The file is created with the first
/// frame. For each further frame it is opened as HDF5's single writer with many readers, extended and closed:
/// whenever the process is killed, all complete frames can be read.
class SnapshotLog {
 public:
  /// `program`: name and version of the writing program. Throws what check_snapshot_name throws.
  SnapshotLog(std::string file, std::string program, SnapshotParameters parameters);

  /// Continues the file if it exists: frames after `present` are dropped, since the run will reach them
  /// again. Returns their number. If the engine counts time anew (after a restart), the times of further
  /// frames continue those in the file. Throws (bad input) if the file belongs to another system: other
  /// parameters, or discs whose type or radius differs from the disc with the same id in `present`.
  std::int64_t resume(const RawFrame& present);

  /// Appends the frame, in a new file unless one was resumed; does nothing if the last frame has the same
  /// step. Throws on steps that do not increase, on another program writing to the same file (failed run),
  /// and on everything that SnapshotWriter throws on.
  void add(const RawFrame& frame);

 private:
  void create(const RawFrame& frame);
  void append(const RawFrame& frame);

  std::string file_;
  std::string program_;
  SnapshotParameters parameters_;
  std::uint64_t frames_ = 0;
  std::int64_t last_step_ = -1;
  bool begun_ = false;
  double time_shift_ = 0;  // s, from the engine's time to that of the file
};

/// Throws (bad input) if the file cannot be written, or if its name is not that of an HDF5 file.
void check_snapshot_name(const std::string& file);

}  // namespace mikromakro
