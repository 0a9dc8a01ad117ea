// Frames of LAMMPS / LIGGGHTS text dumps, particles and contacts matched by their time step.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/dump_reader.h"
#include "io/frame_format.h"

namespace mikromakro {

/// The frames of several dump files as one sequence, files in the order of their first time steps.
/// Throws when the time steps do not ascend.
class DumpSequence {
 public:
  explicit DumpSequence(const std::vector<std::string>& files);

  bool next(DumpHeader& header);
  DumpReader& dump() { return *dump_; }
  std::int64_t bytes_read() const { return bytes_before_ + (dump_ ? dump_->bytes_read() : 0); }

 private:
  std::vector<std::string> files_;
  std::size_t opened_ = 0;
  std::unique_ptr<DumpReader> dump_;
  std::optional<std::int64_t> last_step_;
  std::int64_t bytes_before_ = 0;
};

/// Which columns are asked for, and what the user calls those that the dumps do not name.
struct ColumnWishes {
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
};

/// Throws: a time step that only the particles or only the contacts have, and all that read_particles and
/// read_contacts throw.
class TextFrames : public FrameFormat {
 public:
  /// No contact files: frames without contacts.
  TextFrames(const std::vector<std::string>& particle_files, const std::vector<std::string>& contact_files,
             ColumnWishes wishes);

  bool next(std::int64_t& step) override;
  UnpackFrame take() override;
  std::int64_t bytes_read() const override;

 private:
  void check_partners(bool some_particles, bool some_contacts);

  std::shared_ptr<const ColumnWishes> wishes_;
  DumpSequence particles_;
  std::optional<DumpSequence> contacts_;
  DumpHeader of_particles_;
  DumpHeader of_contacts_;
};

}  // namespace mikromakro
