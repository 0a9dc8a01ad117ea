// SPDX-License-Identifier: GPL-2.0-or-later
// What to average and how, as the program and the runs of engines are asked for it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "averaging/block_errors.h"
#include "averaging/time_average.h"
#include "options/field_options.h"
#include "options/table_outputs.h"
#include "options/volume_options.h"

namespace mikromakro {

struct AverageOptions {
  VolumeOptions volumes;
  FieldChoice fields;
  std::vector<std::string> out;
  std::optional<std::size_t> error_blocks;  ///< else suitable_blocks
};

void add_average_options(CLI::App& app, AverageOptions& options);

/// The averager that the options ask for. Throws on options that contradict each other or have no meaning.
std::unique_ptr<const Averager> make_averager(const AverageOptions& options);

/// Sums without frames, with the blocks for errors that the options want.
TimeAverage no_sums(const AverageOptions& options, const Averager& averager);
/// How many blocks that are.
std::size_t error_blocks(const AverageOptions& options, const Averager& averager);

/// Time steps of the first and the last frame.
struct FrameRange {
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
};

struct Averaged {
  TimeAverage sums;
  FrameRange range;

  void add(std::int64_t step, const Rows& frame_sums, std::int64_t run = 0);
};

/// Line above a table: which frames.
void describe_frames(const Averaged& averaged, Preamble& lines);

/// Solves the table, with errors unless the options have none, and writes it out below `lines`, to which all
/// that the options say is added. There must be a frame. What the errors rest on is given back.
BlockErrors write_averages(const AverageOptions& options, const Averager& averager, const Averaged& averaged,
                           Preamble lines, TableOutputs& outputs);

}  // namespace mikromakro
