// SPDX-License-Identifier: GPL-2.0-or-later
// Fits of profiles in tables of rings.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "io/tables/csv_reader.h"
#include "verbs/fit_report.h"

namespace mikromakro {

struct FitOptions {
  std::vector<std::string> files;
  std::string column = "v_phi", weights, blocks;  ///< no weights: none
  std::vector<double> range;
  double ri = std::nan("");
  double omega = std::nan("");
  bool log = false, json = false, without_tail = false;
};

/// Throws if the table is not one of rings; notes rings whose radius is not in the middle.
void check_ring_table(const CsvTable& table);

/// Fits the profile of the first table; further ones, of the same discs and frames, are choices beside it.
FitReport fit_tables(const std::vector<CsvTable>& tables, const FitOptions& options);

}  // namespace mikromakro
