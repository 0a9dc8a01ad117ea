// SPDX-License-Identifier: GPL-2.0-or-later
// The snapshot file of a run: frame after frame, whatever happens to the run.
#pragma once

#include <string>

#include "io/frames/frame_format.h"
#include "io/snapshot/snapshot_parameters.h"

namespace mikromakro {

/// Appends frames to one HDF5 file in the layout of snapshot_layout.h, which may be read at any time. The
/// file appears with its first frame. For each further one it is opened, added to as HDF5's single writer
/// beside many readers, and closed: whenever the process is killed, the frames that were complete can be
/// read.
class SnapshotLog {
 public:
  /// `program`: name and version of who writes. Throws what check_snapshot_name throws.
  SnapshotLog(std::string file, std::string program, SnapshotParameters parameters);

  /// Continues the file, if it is there: frames after `present` are dropped, for the run comes by there
  /// again. Gives their number. Throws (bad input) where the file is of another system: other parameters, or
  /// discs of the same id that have another type or radius than in `present`.
  std::int64_t resume(const RawFrame& present);

  /// Appends the frame, in a new file unless this one was resumed; nothing where the last frame has its step.
  /// Throws: steps that do not ascend, another program that writes to the same file (failed run), and all
  /// that SnapshotWriter throws.
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
};

/// Throws (bad input) where no such file can be written, or its name is none of an HDF5 file.
void check_snapshot_name(const std::string& file);

}  // namespace mikromakro
