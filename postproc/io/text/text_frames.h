// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of LAMMPS / LIGGGHTS text dumps, particles and contacts matched by their time step.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/text/dump_reader.h"
#include "io/text/matched_frames.h"
#include "model/notes.h"
#include "model/units.h"

namespace mikromakro {

/// Which columns are asked for, and what the user calls those that the dumps do not name; `notes` takes what
/// must be told and stops nothing.
struct ColumnWishes {
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  std::shared_ptr<Notes> notes = std::make_shared<Notes>();
  FrameSelection selection = {};  ///< to say nothing about other steps
  bool look_through = false;      ///< whether files are looked through for steps that come again
  std::vector<std::string> wall_columns = {};
};

/// Frames that only the particles or only the contacts have, and steps of which a piece is missing, are left
/// out and noted. Numbers are converted to SI where a dump names its units. Throws: no step in both, units
/// that contradict each other, and all that units_of, read_particles and read_contacts throw.
class TextFrames : public FrameFormat {
 public:
  /// Neither contact nor wall files: frames without contacts.
  TextFrames(const std::vector<std::string>& particle_files, const std::vector<std::string>& contact_files,
             ColumnWishes wishes, const std::vector<std::string>& wall_files = {});

  bool next(std::int64_t& step) override;
  UnpackFrame take(bool closely = false) override;
  std::int64_t contact_rows() const override;
  std::int64_t bytes_read() const override { return frames_.bytes_read(); }

 private:
  struct Packed;
  void check_boundaries();
  void check_system();
  void find_units();

  std::shared_ptr<const ColumnWishes> wishes_;
  MatchedFrames<DumpHeader, RowBlock> frames_;
  std::size_t particle_pieces_ = 0;
  std::size_t contact_pieces_ = 0;
  std::string units_name_;  ///< empty: no dump has named them so far
  Units units_;
  bool some_taken_ = false;
  std::optional<Box> last_box_;
  struct Size {
    Box box;
    std::int64_t rows;
  };
  std::optional<Size> last_size_;  ///< of the frame before
};

}  // namespace mikromakro
