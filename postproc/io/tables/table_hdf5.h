// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of averages as HDF5 that explains itself.
#pragma once

#include <string>

#include "io/tables/csv_writer.h"

namespace mikromakro {

/// /table/<column>: one dataset of doubles per column, each with attributes unit, equation and text;
/// attribute `columns` of /table: their names in order. The root has what stands above a CSV: program and
/// version, inputs, options, one attribute for each name (a list where a name is there more than once).
void write_table_hdf5(const std::string& file, const Preamble& preamble, const Table& table);

}  // namespace mikromakro
