// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of any kind of input, one in memory at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/frames/frame_selection.h"
#include "io/text/text_frames.h"
#include "joining/contact_geometry.h"
#include "model/frame.h"

namespace mikromakro {

/// The files of one run: HDF5 snapshots, or others.
struct Run {
  std::vector<std::string> particle_files = {};
  std::vector<std::string> contact_files = {};
  std::vector<std::string> snapshot_files = {};
  std::vector<std::string> wall_files = {};
};

/// What to read, and how: HDF5 snapshots, text dumps, or MercuryDPM's files, which are known by their
/// content.
struct FrameSource {
  std::vector<std::string> particle_files;
  std::vector<std::string> contact_files;  ///< none: frames without contacts
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  FrameSelection selection;
  std::optional<FrameSelection> of_all_ranks = {};  ///< where `selection` is the part of one of several ranks
  std::vector<std::string> snapshot_files = {};     ///< none: text dumps
  std::vector<Run> further_runs = {};               ///< read after the files above, which are the first run
  double density = 0;                               ///< areal (kg/m^2), > 0: for files that give no masses
  bool contacts_required = false;                   ///< frames without contacts are an error
  /// Files are read once more before, so that steps that come again (after a restart) can be left out;
  /// without it they throw Error::Kind::steps_come_again.
  bool look_through = false;
  /// What reading finds and the user must know; copies of the source share it.
  std::shared_ptr<Notes> notes = std::make_shared<Notes>();
  std::vector<std::string> wall_files = {};  ///< contacts with walls, beside those of discs
  std::vector<std::string> wall_columns = {};
  bool distant_contacts = false;         ///< forces may act between discs that do not touch
  std::vector<int> averaged_types = {};  ///< contacts of others may be missing; empty: of none

  ColumnWishes wishes() const;
  std::vector<Run> runs() const;
  /// The selection counted from the beginning, for which frames are counted where it must be.
  FrameSelection settled_selection() const;
  struct Count {
    std::int64_t frames = 0;
    std::int64_t first_step = 0, last_step = 0;
  };
  /// How many frames there are, for which they are read.
  Count count() const;
  /// What to throw where none of them is selected.
  Error no_frame_selected() const;
  /// All files there are.
  std::vector<std::string> files() const;
};

/// Makes the frame of bytes that were read before; any thread may do it.
using MakeFrame = std::function<void(Frame&)>;

/// Particles go over to the frame, contacts become those of particles. Throws: ids that are there twice, and
/// all that join_contacts throws.
void join(RawFrame& raw, Frame& frame, ContactRules rules);

/// Frames are looked at closely now and then, the first of each run and every 64th of those that all ranks
/// read: what costs time but finds what is wrong in a whole file. Throws: contacts that are required and not
/// there, masses where a density is given, too; ids that are there twice, and all that the formats and
/// join_contacts throw.
class FrameStream {
 public:
  explicit FrameStream(const FrameSource& source);

  /// Reads the next selected frame; false when there is none.
  bool next(Frame& frame);

  /// Takes the bytes of the next selected frame, so that the rest of the work can be done elsewhere while the
  /// stream goes on; an empty function when there is none.
  MakeFrame take();

  /// The rows that the last frame of `next` was made of; particles are in the frame.
  const RawFrame& raw() const { return raw_; }
  std::int64_t bytes_read() const { return format_->bytes_read(); }

 private:
  UnpackFrame take_raw();
  void note_last_frame();
  bool is_looked_at_closely(std::int64_t step);

  FrameSelection selection_, of_all_ranks_;
  double density_;
  bool contacts_required_;
  bool distant_contacts_;
  std::vector<int> averaged_types_;
  std::shared_ptr<Notes> notes_;
  bool one_run_;
  std::unique_ptr<FrameFormat> format_;
  RawFrame raw_;
  std::int64_t index_ = -1;
  std::int64_t selected_ = 0;  ///< frames of all ranks so far
  std::int64_t last_selected_run_ = -1;
  std::int64_t selected_of_run_ = 0;
  std::int64_t most_rows_looked_at_ = 0, least_rows_looked_at_ = 0;  ///< of a frame of that run
  bool closely_ = false;
  bool over_ = false;
};

}  // namespace mikromakro
