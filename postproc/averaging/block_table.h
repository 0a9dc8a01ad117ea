// SPDX-License-Identifier: GPL-2.0-or-later
// What fits of averaged columns need for their errors: the columns as they would be without a block of
// frames.
#pragma once

#include "averaging/averager.h"
#include "averaging/time_average.h"
#include "io/tables/csv_reader.h"

namespace mikromakro {

/// The table of the averages, solved from the mean of all blocks but one, for each block one below the other.
/// Columns in front of it: `block` from 1 on, the `run` it is of, from 1 on, and its `frames`. Block 0 is the
/// mean of all frames. Throws (failed run) where there are fewer than two blocks.
Table block_table(const Averager& averager, const TimeAverage& average);

/// One column of it.
struct ColumnWithoutBlocks {
  Eigen::ArrayXXd values;  ///< a row for each of the volumes, a column for each block that is left out
  std::vector<std::int64_t> runs;
  double frames = 0;  ///< of each block
};

/// Of the table of such a file. Throws where it is none, or where its block 0 is not `table`: then its blocks
/// are of other frames, volumes or options.
ColumnWithoutBlocks column_without_blocks(const CsvTable& blocks, const std::string& column,
                                          const CsvTable& table);

}  // namespace mikromakro
