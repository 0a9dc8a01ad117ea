// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of averages as self-describing HDF5.
#pragma once

#include <string>

#include "io/hdf5/hdf5_file.h"
#include "io/tables/csv_writer.h"

namespace mikromakro {

/// /table/<column>: one dataset of doubles per column, with the attributes unit, equation and text; the
/// attribute `columns` of /table lists their names in order. The root has the header of a CSV file as
/// attributes: program and version, inputs, options, one attribute per name (a list if a name occurs more
/// than once).
void write_table_hdf5(const std::string& file, const Preamble& preamble, const Table& table);

/// The attributes of a column, and those of the table and the root.
void describe_column(Hdf5File& out, const Column& column);
void describe_table(Hdf5File& out, const Preamble& preamble, const std::vector<Column>& columns);

}  // namespace mikromakro
