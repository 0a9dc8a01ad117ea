// Frames of particle and contact dumps, matched by their time step, one in memory at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/dump_reader.h"
#include "io/frame.h"
#include "io/frame_selection.h"

namespace mikromakro {

/// The frames of several dump files as one sequence, files in the order of their first time steps.
/// Throws when the time steps do not ascend.
class DumpSequence {
 public:
  explicit DumpSequence(const std::vector<std::string>& files);

  bool next(DumpHeader& header);
  DumpReader& dump() { return *dump_; }
  const std::vector<std::string>& files() const { return files_; }
  std::int64_t bytes_read() const { return bytes_before_ + (dump_ ? dump_->bytes_read() : 0); }

 private:
  std::vector<std::string> files_;
  std::size_t opened_ = 0;
  std::unique_ptr<DumpReader> dump_;
  std::optional<std::int64_t> last_step_;
  std::int64_t bytes_before_ = 0;
};

/// What to read, and how.
struct FrameSource {
  std::vector<std::string> particle_files;
  std::vector<std::string> contact_files;  ///< none: frames without contacts
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  FrameSelection selection;
};

/// Throws: a time step that only the particles or only the contacts have, ids that are there twice, and all
/// that read_particles, read_contacts and join_contacts throw.
class FrameStream {
 public:
  explicit FrameStream(const FrameSource& source);

  /// Reads the next selected frame; false when there is none.
  bool next(Frame& frame);

  std::int64_t bytes_read() const;

 private:
  bool next_headers(DumpHeader& of_particles, DumpHeader& of_contacts);
  void read(const DumpHeader& of_particles, const DumpHeader& of_contacts, Frame& frame);

  FrameSource source_;
  DumpSequence particles_;
  std::optional<DumpSequence> contacts_;
  std::int64_t index_ = -1;
  bool over_ = false;
};

}  // namespace mikromakro
