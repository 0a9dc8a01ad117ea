// SPDX-License-Identifier: GPL-2.0-or-later
// Writes frames to an HDF5 file.
#pragma once

#include <map>
#include <string>

#include "io/frames/frame_format.h"
#include "io/hdf5/hdf5_file.h"
#include "io/snapshot/snapshot_parameters.h"
#include "io/snapshot/wall_series.h"

namespace mikromakro {

/// Writes frames one by one, in the layout of snapshot_layout.h; numbers as doubles, bit for bit. The first
/// frame defines the contents of the file. Throws if a later frame has other columns, another box or other
/// periodicity (bad input), and on a full disk (failed run).
class SnapshotWriter {
 public:
  /// The file of a run is appended to while others read it and the run may be killed at any time. Checksummed
  /// data that frames share are therefore never rewritten, which a kill could interrupt: only data of a
  /// single frame have checksums, and the step is written last.
  enum class Use { finished, running };

  /// `time_step` > 0 (s): also writes times. `program`: name and version, stored as the file's creator.
  SnapshotWriter(const std::string& file, const std::string& program, double time_step);
  /// Takes the times from the frames.
  SnapshotWriter(const std::string& file, const std::string& program, Use use);
  /// Continues a file of a run, `name`; an unfinished frame is overwritten.
  SnapshotWriter(Hdf5File file, const std::string& name);

  std::uint64_t frames() const { return frames_; }
  /// Throws if `frame` has other columns or boundaries than the file.
  void check_same(const RawFrame& frame) const;
  /// Truncates a continued file to its first `frames` frames.
  void keep(std::uint64_t frames);

  void add(const RawFrame& frame, const std::vector<Particle>& particles);
  void add_parameters(const SnapshotParameters& parameters) { write_parameters(file_, parameters); }
  /// Copies the parameters of another file, if it has any.
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
