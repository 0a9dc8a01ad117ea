// Frames into one HDF5 file.
#pragma once

#include <map>
#include <string>

#include "io/frame_format.h"
#include "io/hdf5_file.h"

namespace mikromakro {

/// Writes frames one by one, in the layout of snapshot_layout.h; numbers as doubles, bit by bit. What the
/// first frame gives is what the file holds. Throws: a later frame gives other columns, another box or
/// periodicity of another kind (bad input); a disk that is full (failed run).
class SnapshotWriter {
 public:
  /// `time_step` > 0 (s): times are written too. `program`: name and version, for the file's creator.
  SnapshotWriter(const std::string& file, const std::string& program, double time_step);

  void add(const RawFrame& frame, const std::vector<Particle>& particles);
  /// Nothing of the file stays open: it is complete.
  void close() {
    datasets_.clear();
    file_.close();
  }

 private:
  void begin(const RawFrame& frame, std::size_t particles);
  void begin_element(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk, std::string_view unit);
  void begin_contacts(const RawFrame& frame);
  void check_same(const RawFrame& frame) const;
  void add_particles(const std::vector<Particle>& particles);
  void add_contacts(const ContactRows& rows);
  void append(const std::string& path, double number);
  void append(const std::string& path, std::int64_t number);

  Hdf5File file_;
  std::string program_;
  double time_step_;
  std::map<std::string, Hdf5Dataset, std::less<>> datasets_;
  ColumnSet particles_given_ = 0;
  ColumnSet contacts_given_ = 0;
  std::array<bool, 2> periodic_ = {false, false};
  std::uint64_t frames_ = 0;
  std::uint64_t most_particles_ = 0;
  std::uint64_t rows_ = 0;
};

}  // namespace mikromakro
