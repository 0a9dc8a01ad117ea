// SPDX-License-Identifier: GPL-2.0-or-later
// Reads frames of our HDF5 snapshots.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/hdf5/hdf5_file.h"
#include "io/snapshot/snapshot_summary.h"
#include "io/text/text_frames.h"

namespace mikromakro {

/// Reads one frame at a time, and only the columns needed. Checks numbers like the text readers; in messages,
/// the line is the row within the frame. Throws on missing or damaged HDF5 files, missing columns, time steps
/// that do not increase, and non-finite numbers. If a file begins with the last step of the one before it,
/// only the later frame counts.
class SnapshotReader : public FrameFormat {
 public:
  SnapshotReader(std::vector<std::string> files, ColumnWishes wishes);
  ~SnapshotReader() override;

  bool next(std::int64_t& step) override;
  UnpackFrame take(bool closely = false) override;
  std::int64_t contact_rows() const override;
  std::int64_t bytes_read() const override;

 private:
  struct Open;
  struct Packed;
  bool open_next();
  static bool are_of_two_systems(const Open& before, const Open& after);
  std::string place() const;

  std::vector<std::string> files_;
  ColumnWishes wishes_;
  std::unique_ptr<Open> open_;
  std::size_t opened_ = 0;
  std::uint64_t frame_ = 0, frames_ = 0;  // of the open file
  std::int64_t last_step_ = -1;
  std::int64_t bytes_before_ = 0, bytes_ = 0;  // of the files before the open one, and of this
};

}  // namespace mikromakro
