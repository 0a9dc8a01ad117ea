// Frames of LAMMPS / LIGGGHTS text dumps, particles and contacts matched by their time step.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/dump_reader.h"
#include "io/file_sequence.h"
#include "io/frame_format.h"
#include "io/notes.h"
#include "io/wall_dumps.h"

namespace mikromakro {

/// Which columns are asked for, and what the user calls those that the dumps do not name; `notes` takes what
/// must be told and stops nothing.
struct ColumnWishes {
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  std::shared_ptr<Notes> notes = std::make_shared<Notes>();
  std::vector<std::string> wall_columns = {};
};

/// Throws: a time step that only the particles or only the contacts have, and all that read_particles and
/// read_contacts throw.
class TextFrames : public FrameFormat {
 public:
  /// Neither contact nor wall files: frames without contacts.
  TextFrames(const std::vector<std::string>& particle_files, const std::vector<std::string>& contact_files,
             ColumnWishes wishes, const std::vector<std::string>& wall_files = {});

  bool next(std::int64_t& step) override;
  UnpackFrame take() override;
  std::int64_t bytes_read() const override;

 private:
  void check_partners(bool some_particles, bool some_contacts);

  std::shared_ptr<const ColumnWishes> wishes_;
  FileSequence<DumpReader> particles_;
  std::optional<FileSequence<DumpReader>> contacts_;
  DumpHeader of_particles_;
  DumpHeader of_contacts_;
  std::unique_ptr<WallDumps> walls_;
};

}  // namespace mikromakro
