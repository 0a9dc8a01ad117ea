// Options that say what is read: files, columns, frames. Shared by the verbs that read snapshots.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "averaging/averager.h"
#include "io/csv_writer.h"
#include "io/frame_stream.h"

namespace mikromakro {

struct InputOptions {
  std::vector<std::string> particles, contacts, particle_columns, contact_columns;
  std::string frames, steps;
};

void add_input_options(CLI::App& app, InputOptions& options);

/// What to read for the fields of `averager`. Throws when they need contacts and none are given.
FrameSource source_of(const InputOptions& options, const Averager& averager);

/// Time steps of the first and the last frame that was read.
struct FrameRange {
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
};

/// Lines above a table: the inputs and how they were read.
void describe_input(const InputOptions& options, const FrameSource& source, Preamble& lines);

}  // namespace mikromakro
