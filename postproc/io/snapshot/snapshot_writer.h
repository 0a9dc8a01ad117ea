// SPDX-License-Identifier: GPL-2.0-or-later
// Frames into one HDF5 file.
#pragma once

#include <map>
#include <string>

#include "io/frames/frame_format.h"
#include "io/hdf5/hdf5_file.h"
#include "io/snapshot/snapshot_parameters.h"
#include "io/snapshot/wall_series.h"

namespace mikromakro {

/// Writes frames one by one, in the layout of snapshot_layout.h; numbers as doubles, bit by bit. What the
/// first frame gives is what the file holds. Throws: a later frame gives other columns, another box or
/// periodicity of another kind (bad input); a disk that is full (failed run).
class SnapshotWriter {
 public:
  /// A file of a run is added to while others read it, and whatever happens to the run: what frames share is
  /// never written anew with a sum that a kill could leave half-way, so only what belongs to one frame has
  /// sums; and the step comes last.
  enum class Use { finished, running };

  /// `time_step` > 0 (s): times are written too. `program`: name and version, for the file's creator.
  SnapshotWriter(const std::string& file, const std::string& program, double time_step);
  /// Times are those of the frames.
  SnapshotWriter(const std::string& file, const std::string& program, Use use);
  /// Continues a file of a run, `name`, whose unfinished frame, if there is one, is written over.
  SnapshotWriter(Hdf5File file, const std::string& name);

  std::uint64_t frames() const { return frames_; }
  /// Throws where `frame` has other columns or boundaries than those that are there.
  void check_same(const RawFrame& frame) const;
  /// Drops all frames but the first ones of a file that was continued.
  void keep(std::uint64_t frames);

  void add(const RawFrame& frame, const std::vector<Particle>& particles);
  void add_parameters(const SnapshotParameters& parameters) { write_parameters(file_, parameters); }
  /// Those of another file, if it has any.
  void copy_parameters(const Hdf5File& run);
  void close();

 private:
  void begin(const RawFrame& frame, std::size_t particles);
  void begin_element(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk, std::string_view unit);
  void begin_contacts(const RawFrame& frame, std::size_t particles);
  void resume(const std::string& name);
  void add_particles(const std::vector<Particle>& particles);
  void add_contacts(const ContactRows& rows);
  template <typename T>
  void put(const std::string& path, std::uint64_t index, T number);

  Hdf5File file_;
  std::string program_;
  double time_step_ = 0;
  Use use_ = Use::finished;
  bool with_time_ = false;
  WallSeries walls_;
  std::map<std::string, Hdf5Dataset, std::less<>> datasets_;
  ColumnSet particles_given_ = 0;
  ColumnSet contacts_given_ = 0;
  std::array<bool, 2> periodic_ = {false, false};
  std::uint64_t frames_ = 0;
  std::uint64_t most_particles_ = 0;
  std::uint64_t rows_ = 0;
};

}  // namespace mikromakro
