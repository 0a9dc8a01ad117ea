// SPDX-License-Identifier: GPL-2.0-or-later
// Fits of the profiles in a table of windows: v0 and s as functions of time.
#pragma once

#include <utility>

#include "io/tables/csv_writer.h"
#include "verbs/profile_fit.h"

namespace mikromakro {

/// Whether the table is one of `average --every`, `--per-frame` or `--moving`.
bool is_series(const CsvTable& table);

/// The table with the fit of each window, below its header; a window whose profile cannot be fitted has nan,
/// with a warning. Throws if none can be fitted, and unless there is exactly one table, without blocks.
std::pair<Preamble, Table> fit_windows(const std::vector<CsvTable>& tables, const FitOptions& options);

}  // namespace mikromakro
