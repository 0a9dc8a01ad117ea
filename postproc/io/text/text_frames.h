// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of LAMMPS / LIGGGHTS text dumps, with particles and contacts matched by time step.
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
#include "model/wall_numbers.h"

namespace mikromakro {

/// Requested columns, and the user's names for columns that the dumps do not name; `notes` receives the
/// warnings.
struct ColumnWishes {
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  std::shared_ptr<Notes> notes = std::make_shared<Notes>();
  FrameSelection selection = {};  ///< other steps cause no notes
  bool look_through = false;      ///< scan the files first for repeated steps
  std::vector<std::string> wall_columns = {};
  std::vector<WallNumbers> walls = {};  ///< numbers of walls to read, of snapshots
};

/// Frames missing from the particle or contact files, and steps with a missing piece, are left out and noted.
/// Numbers are converted to SI if a dump names its units. Throws if no step is in both, if units contradict
/// each other, and on everything that units_of, read_particles and read_contacts throw on.
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
  void note_names();
  void check_boundaries();
  void check_system();
  void find_units();

  std::shared_ptr<const ColumnWishes> wishes_;
  MatchedFrames<DumpHeader, RowBlock> frames_;
  std::size_t particle_pieces_ = 0;
  std::size_t contact_pieces_ = 0;
  std::string units_name_;  ///< empty: not named by any dump so far
  Units units_;
  bool some_taken_ = false;
  std::optional<Box> last_box_;
  struct Size {
    Box box;
    std::int64_t rows;
  };
  std::optional<Size> last_size_;  ///< of the previous frame
  std::int64_t rows_before_last_ = -1;
};

}  // namespace mikromakro
