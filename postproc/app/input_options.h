// The options that say which frames a verb reads.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "io/frame_stream.h"

namespace mikromakro {

struct InputOptions {
  std::vector<std::string> snapshots, particles, contacts, particle_columns, contact_columns;
  std::string frames, steps;
};

void add_input_options(CLI::App& app, InputOptions& options);

/// Names expanded, ranges parsed. Throws on patterns that match nothing, on ranges that are none, and unless
/// there are either snapshots or dumps.
FrameSource frame_source(const InputOptions& options);

/// Throws when contacts are needed for `what` and there are none.
void require_contacts(const InputOptions& options, std::string_view what);

}  // namespace mikromakro
