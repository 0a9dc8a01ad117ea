// SPDX-License-Identifier: GPL-2.0-or-later
// Fits of the profiles in a table of windows: v0 and s as functions of time.
#pragma once

#include "app/profile_fit.h"

namespace mikromakro {

/// Whether the table is one of `average --every`, `--per-frame` or `--moving`.
bool is_series(const CsvTable& table);

/// Prints a table with the fit of each window; a window whose profile cannot be fitted has nan, with a
/// warning. Throws if none can be fitted, and unless there is exactly one table, without blocks.
void fit_windows(const std::vector<CsvTable>& tables, const FitOptions& options);

}  // namespace mikromakro
