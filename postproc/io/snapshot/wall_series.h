// SPDX-License-Identifier: GPL-2.0-or-later
// The wall data of a snapshot file, frame by frame.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/hdf5/hdf5_file.h"
#include "model/wall_numbers.h"

namespace mikromakro {

/// /walls of snapshot_layout.h. The walls of the first frame are those of the file.
class WallSeries {
 public:
  /// Creates the datasets. `step_path`, `time_path`: targets that /walls/<name>/step and time are linked to,
  /// the latter "" if there is none.
  void begin(Hdf5File& file, const std::vector<WallState>& walls, const std::string& step_path,
             const std::string& time_path);
  /// Opens those of an existing file.
  void resume(const Hdf5File& file);

  /// Throws if a wall is not in the file, or has a different number of values.
  void check(const std::vector<WallState>& walls, const Place& place) const;

  /// nan for walls that are missing from this frame. Throws what check() throws.
  void add(const std::vector<WallState>& walls, std::uint64_t frame, const Place& place);

 private:
  std::map<std::string, Hdf5Dataset, std::less<>> values_;
};

/// The walls of a file with the names and units of their numbers. Files without names have those of the fix's
/// style, or numbers.
std::vector<WallNumbers> wall_numbers(const Hdf5File& file);
/// Those of several files, each wall once.
std::vector<WallNumbers> wall_numbers(const std::vector<std::string>& files);

/// Reads them frame by frame.
class WallReader {
 public:
  /// Opens the `wanted` walls; one that the file does not have, or with fewer or more numbers, is nan.
  WallReader(const Hdf5File& file, const std::vector<WallNumbers>& wanted);
  std::vector<WallState> read(std::uint64_t frame) const;

 private:
  struct Series {
    std::string wall;
    std::size_t count;
    Hdf5Dataset values;
  };
  std::vector<Series> series_;
};

}  // namespace mikromakro
