// SPDX-License-Identifier: GPL-2.0-or-later
// Averaging options, shared by the program and the in-situ averaging of the engines.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
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
  std::optional<std::size_t> error_blocks;  ///< unset: suitable_blocks()
  GivenValues given = {};                   ///< of fields.numbers.given (not an option)
};

void add_average_options(CLI::App& app, AverageOptions& options);

/// The averager for these options. Throws on contradictory or meaningless options.
std::unique_ptr<const Averager> make_averager(const AverageOptions& options);

/// Throws on --branch and --height where none of the fields has to do with them.
void check_use(const VolumeOptions& given, const Averager& averager);

/// Empty sums, with the number of error blocks requested by the options.
TimeAverage no_sums(const AverageOptions& options, const Averager& averager);
/// That number.
std::size_t error_blocks(const AverageOptions& options, const Averager& averager);

/// Time steps of the first and the last frame.
struct FrameRange {
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
};

struct Averaged {
  TimeAverage sums;
  FrameRange range;
  std::set<std::int64_t> runs = {};  ///< that the frames belong to
  std::string first_frame = {};      ///< what it holds, to tell averages of other input by

  void add(std::int64_t step, const Rows& frame_sums, std::int64_t run = 0);
};

/// Adds the header line that says which frames were averaged.
void describe_frames(const Averaged& averaged, Preamble& lines);

/// A table with its header, and how its errors were obtained.
struct AveragedTable {
  Preamble lines;
  Table table;
  BlockErrors errors;
};

/// Computes the table, with errors unless the options disable them, below `lines` and a description of all
/// options. At least one frame is required.
AveragedTable averaged_table(const AverageOptions& options, const Averager& averager,
                             const Averaged& averaged, Preamble lines);
void write_averages(const AverageOptions& options, const AveragedTable& averages, TableOutputs& outputs);

}  // namespace mikromakro
