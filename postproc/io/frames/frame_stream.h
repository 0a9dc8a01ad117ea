// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of any input format, one in memory at a time.
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

/// The files of one run: either HDF5 snapshots or other formats.
struct Run {
  std::vector<std::string> particle_files = {};
  std::vector<std::string> contact_files = {};
  std::vector<std::string> snapshot_files = {};
  std::vector<std::string> wall_files = {};
};

/// What to read, and how: HDF5 snapshots, text dumps, or MercuryDPM files, which are recognised by content.
struct FrameSource {
  std::vector<std::string> particle_files;
  std::vector<std::string> contact_files;  ///< none: frames without contacts
  std::vector<std::string> particle_columns;
  std::vector<std::string> contact_columns;
  ColumnSet particles_needed = 0;
  ColumnSet contacts_needed = 0;
  FrameSelection selection;
  std::optional<FrameSelection> of_all_ranks = {};  ///< set if `selection` is this rank's part of it
  std::vector<std::string> snapshot_files = {};     ///< none: text dumps
  std::vector<Run> further_runs = {};               ///< read after the files above, which form the first run
  double density = 0;                               ///< areal (kg/m^2), > 0: for files without masses
  bool contacts_required = false;                   ///< a frame without contacts is an error
  /// Whether to scan the files first, so that repeated steps (after a restart) can be left out; without it,
  /// such steps throw Error::Kind::steps_come_again.
  bool look_through = false;
  /// Warnings found while reading; shared by copies of the source.
  std::shared_ptr<Notes> notes = std::make_shared<Notes>();
  std::vector<std::string> wall_files = {};  ///< contacts with walls, in addition to those of discs
  std::vector<std::string> wall_columns = {};
  bool distant_contacts = false;         ///< forces may act between discs that do not touch
  std::vector<WallNumbers> walls = {};   ///< numbers of walls that frames shall carry
  std::vector<int> averaged_types = {};  ///< contacts of others may be missing; empty: none may

  ColumnWishes wishes() const;
  std::vector<Run> runs() const;
  /// A single run (from 0), with all of its frames, and with its own notes.
  FrameSource one_run(std::size_t run) const;
  /// The selection with non-negative indices; counts the frames if necessary.
  FrameSelection settled_selection() const;
  struct Count {
    std::int64_t frames = 0;
    std::int64_t first_step = 0, last_step = 0;
  };
  /// Counts the frames by reading them.
  Count count() const;
  /// The error to throw if no frame is selected.
  Error no_frame_selected() const;
  /// All input files.
  std::vector<std::string> files() const;
};

/// Builds a frame from bytes that were read before; thread-safe.
using MakeFrame = std::function<void(Frame&)>;

/// Moves the particles to the frame and joins the contacts to them. Throws on duplicate ids, and on
/// everything that join_contacts throws on.
void join(RawFrame& raw, Frame& frame, ContactRules rules);

/// Some frames are checked closely: the first of each run and every 64th of those read by all ranks. These
/// checks are expensive but find faults that affect a whole file. Throws on required contacts that are
/// missing, on masses in the file if a density is given, on duplicate ids, and on everything that the formats
/// and join_contacts throw on.
class FrameStream {
 public:
  explicit FrameStream(const FrameSource& source);

  /// Reads the next selected frame; false if there is none.
  bool next(Frame& frame);

  /// Reads the bytes of the next selected frame, so that it can be built elsewhere while the stream advances;
  /// an empty function if there is none.
  MakeFrame take();

  /// The rows from which next() built its last frame; the particles have moved to the frame.
  const RawFrame& raw() const { return raw_; }
  std::int64_t bytes_read() const { return format_->bytes_read(); }

 private:
  UnpackFrame take_raw();
  void note_last_frame();
  bool is_checked_closely(std::int64_t step);

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
  std::int64_t most_rows_checked_ = 0, least_rows_checked_ = 0;  ///< contact rows per frame of that run
  bool closely_ = false;
  bool over_ = false;
};

}  // namespace mikromakro
