// SPDX-License-Identifier: GPL-2.0-or-later
// Reports how the standard errors of a table were obtained.
#pragma once

#include "averaging/block_errors.h"
#include "io/tables/csv_writer.h"
#include "io/tables/json.h"

namespace mikromakro {

/// Header lines of a table: the blocks, then for each field 2 tau with its uncertainty, its effective
/// samples, and whether they suffice.
void describe_errors(const BlockErrors& errors, const TimeAverage& average, Preamble& lines);

/// A warning if a run seems to be present twice; else empty.
std::string doubt_of(const BlockErrors& errors);

/// The same as JSON: method, frames, blocks, block_length, and for each field given, series (number that
/// fluctuate), two_tau and two_tau_err in frames, two_tau_scatter, two_tau_scatter_unknown, effective_samples
/// and needed_samples, degrees_of_freedom, slow_wave_ratio, by_runs, chi2_between_runs, widening,
/// nonlinear_columns (without errors because they are not linear), undirected (number of directions without
/// an error). Unknown values are null.
Json error_json(const BlockErrors& errors, const TimeAverage& average);

}  // namespace mikromakro
