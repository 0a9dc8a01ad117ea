// SPDX-License-Identifier: GPL-2.0-or-later
// `average`: fields over rings, sectors or rectangles.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "averaging/parallel/ranks.h"
#include "io/tables/json.h"
#include "options/average_options.h"
#include "options/window_options.h"
#include "verbs/averaging_run.h"
#include "verbs/input_options.h"

namespace mikromakro {

struct AverageCommand {
  InputOptions input;
  AverageOptions average;
  RunOptions run;
  WindowOptions windows;
  std::string steady;  ///< column that must not drift
  std::string blocks;  ///< output file for the table with each block of frames left out
  bool json = false;
  bool returns_table = false;  ///< also that of windows; without --out, nothing is written (not an option)
};

void add_average_command_options(CLI::App& app, AverageCommand& options);

struct AverageResult {
  AveragedTable table;
  Json error_report;  ///< see error_json; null if there are no errors, and of windows
};

/// Averages, writes the files that the options name, and returns the same on rank 0. Collective.
AverageResult average(AverageCommand& options, const Ranks& ranks);

}  // namespace mikromakro
