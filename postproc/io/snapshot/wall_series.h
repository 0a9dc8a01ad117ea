// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of walls, frame by frame, in a snapshot file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

/// /walls of snapshot_layout.h. The walls of the first frame are those of the file.
class WallSeries {
 public:
  /// Makes the datasets; `step_path`, `time_path`: what /walls/<name>/step and time are other names of, the
  /// latter "" where there is none.
  void begin(Hdf5File& file, const std::vector<WallState>& walls, const std::string& step_path,
             const std::string& time_path);
  /// Those of a file that is there.
  void resume(const Hdf5File& file);

  /// Throws where a wall is there that is not in the file, or has another number of numbers.
  void check(const std::vector<WallState>& walls, const Place& place) const;

  /// nan for a wall that is not there in this frame. Throws what check() does.
  void add(const std::vector<WallState>& walls, std::uint64_t frame, const Place& place);

 private:
  std::map<std::string, Hdf5Dataset, std::less<>> values_;
};

}  // namespace mikromakro
