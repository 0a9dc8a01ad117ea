// How the standard errors of a table were made.
#pragma once

#include "averaging/block_errors.h"
#include "io/csv_writer.h"

namespace mikromakro {

/// Lines above the table: the blocks, then for each field 2 tau with its uncertainty and its effective
/// samples, and whether they are enough.
void describe_errors(const BlockErrors& errors, const TimeAverage& average, Preamble& lines);

}  // namespace mikromakro
