// SPDX-License-Identifier: GPL-2.0-or-later
// `fit`: an exponential velocity profile.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "verbs/fit_report.h"

namespace mikromakro {

struct FitOptions {
  std::vector<std::string> files;
  std::string column = "v_phi", weights, blocks;  ///< no weights: none
  std::vector<double> range;
  double ri = std::nan("");
  double omega = std::nan("");
  bool log = false, json = false;
};

void add_fit_options(CLI::App& app, FitOptions& options);

/// Fits v0 exp(-(r - R_i)/s) to the first table; the others are choices beside it.
FitReport fit(const FitOptions& options);

}  // namespace mikromakro
