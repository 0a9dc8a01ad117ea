// SPDX-License-Identifier: GPL-2.0-or-later
// The options that say which frames a verb reads.
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
  std::vector<std::vector<std::string>> particles, contacts, walls, snapshot_runs;  ///< for each run
  double density = 0;
  std::string frames, steps;
  bool look_through = false;  ///< no option: see reading_again
  bool distant_contacts = false;

  bool any_contacts() const { return !contacts.empty() || !walls.empty(); }
};

void add_input_options(CLI::App& app, InputOptions& options);

/// Names expanded, ranges parsed. Throws on patterns that match nothing, on ranges that are none, and unless
/// there are either snapshots or dumps.
FrameSource frame_source(const InputOptions& options);

/// Throws when contacts are needed for `what` and there are none.
void require_contacts(const InputOptions& options, std::string_view what);

/// What to read for the fields of `averager`. Throws when they need contacts and none are given.
FrameSource source_of(const InputOptions& options, const Averager& averager);

/// Does `read`. Where steps of text dumps come again, which is seen in their midst, it is done once more from
/// the beginning, with the files looked through before.
void reading_again(InputOptions& options, const std::function<void()>& read);

/// Lines above a table: the inputs and how they were read.
void describe_input(const InputOptions& options, const FrameSource& source, Preamble& lines);

}  // namespace mikromakro
