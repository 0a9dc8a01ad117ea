// SPDX-License-Identifier: GPL-2.0-or-later
// Options that select the frames to read.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "averaging/averager.h"
#include "io/frames/frame_stream.h"
#include "io/tables/csv_writer.h"

namespace mikromakro {

struct InputOptions {
  std::vector<std::string> snapshots, particle_columns, contact_columns, wall_columns;
  std::vector<std::vector<std::string>> particles, contacts, walls, snapshot_runs;  ///< one list per run
  double density = 0;
  std::string frames, steps;
  bool look_through = false;  ///< not an option: see reading_again
  bool distant_contacts = false;

  bool any_contacts() const { return !contacts.empty() || !walls.empty(); }
};

void add_input_options(CLI::App& app, InputOptions& options);

/// Expands names and parses ranges. Throws on patterns without a match, on malformed ranges, and unless
/// either snapshots or dumps are given.
FrameSource frame_source(const InputOptions& options);

/// Throws if contacts are needed for `what` and none are given.
void require_contacts(const InputOptions& options, std::string_view what);

/// What to read for the fields of `averager`. Throws if they need contacts and none are given.
FrameSource source_of(const InputOptions& options, const Averager& averager);

/// Runs `read`. If time steps of text dumps repeat, which shows only during reading, runs it again from the
/// beginning after scanning the files.
void reading_again(InputOptions& options, const std::function<void()>& read);

/// Header lines of a table: the inputs and how they were read.
void describe_input(const InputOptions& options, const FrameSource& source, std::size_t used_runs,
                    Preamble& lines);

/// Whether the contact rows are those of stock engines, without a file of those with walls, and the box may
/// have walls: it is not known to be periodic along both axes.
bool lack_walls(const Frame& frame, const InputOptions& input);

/// For stresses: notes that contact rows of stock engines lack contacts with walls, unless the box is
/// periodic.
void note_walls(const Frame& frame, const InputOptions& input, Notes& notes);

}  // namespace mikromakro
