// SPDX-License-Identifier: GPL-2.0-or-later
// Leave-one-block-out tables, from which fits to averaged columns get their errors.
#pragma once

#include "averaging/averager.h"
#include "averaging/time_average.h"
#include "io/tables/csv_reader.h"

namespace mikromakro {

/// Stacks the tables computed from the mean of all blocks but one, one table per block. Leading columns:
/// `block` from 1, its `run` from 1, and its number of `frames`. Block 0 is the mean of all frames. Throws
/// (failed run) if there are fewer than two blocks.
Table block_table(const Averager& averager, const TimeAverage& average);

/// One column of the table.
struct ColumnWithoutBlocks {
  Eigen::ArrayXXd values;  ///< one row per volume, one column per omitted block
  std::vector<std::int64_t> runs;
  double frames = 0;  ///< in each block
};

/// Extracts a column from such a table read from a file. Throws if it is not such a table; if its block 0
/// differs from `table`, because its blocks belong to other frames, volumes or options; if the rings of any
/// block differ; if runs are mixed; or if the mean of the blocks is not that of all frames in most of the
/// volumes.
ColumnWithoutBlocks column_without_blocks(const CsvTable& blocks, const std::string& column,
                                          const CsvTable& table);

}  // namespace mikromakro
