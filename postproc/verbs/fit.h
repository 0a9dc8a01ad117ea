// SPDX-License-Identifier: GPL-2.0-or-later
// `fit`: exponential velocity profiles.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "io/tables/csv_writer.h"
#include "io/tables/json.h"
#include "verbs/profile_fit.h"

namespace mikromakro {

void add_fit_options(CLI::App& app, FitOptions& options);

struct FitResult {
  std::string text;  ///< as the program prints it
  Json json;
  Preamble lines;  ///< of a table of windows: the header of the fits, and these; else no columns
  Table of_windows;
};

/// Fits v0 exp(-(r - R_i)/s) to the first table, beside which the others are choices, or to each window of a
/// table of windows.
FitResult fit(const FitOptions& options);

}  // namespace mikromakro
