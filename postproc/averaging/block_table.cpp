// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/block_table.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <set>

namespace mikromakro {
namespace {

constexpr Eigen::Index own_columns = 3;

// Stores the rows of one block.
void put(const Rows& solved, const Eigen::Array3d& own, Eigen::Index block, Rows& rows) {
  auto part = rows.middleRows(block * solved.rows(), solved.rows());
  part.leftCols(own_columns).rowwise() = own.transpose();
  part.rightCols(solved.cols()) = solved;
}

// The number of one block, which must be the same in all its volumes.
double of_block(const CsvTable& blocks, const Eigen::ArrayXd& column, Eigen::Index block,
                Eigen::Index volumes) {
  const auto part = column.segment(block * volumes, volumes);
  constexpr double most = 1e15;  // integers are exact up to there
  if (!(part[0] >= 0 && part[0] <= most && part[0] == std::floor(part[0])))
    throw bad_input(blocks.row_place(block * volumes), "not a number of a block, a run or frames",
                    "a whole number", fmt::format("{}", part[0]));
  for (Eigen::Index i = 1; i < volumes; ++i) {
    if (part[i] != part[0])
      throw bad_input(blocks.row_place(block * volumes + i),
                      "a block whose volumes differ from those of the table",
                      fmt::format("{} rows of the same block, run and frames", volumes),
                      fmt::format("{} after {}", part[i], part[0]));
  }
  return part[0];
}

// Compares block 0, or all of them, with the table.
void check_same(const CsvTable& blocks, const CsvTable& table, const std::string& name, bool in_all) {
  const Eigen::ArrayXd here = blocks.column(name), all_there = table.column(name);
  for (Eigen::Index i = 0; i < (in_all ? blocks.rows() : table.rows()); ++i) {
    const double there = all_there[i % table.rows()];
    if (here[i] != there && !(std::isnan(here[i]) && std::isnan(there)))
      throw bad_input(blocks.row_place(i), fmt::format("the blocks are not those of {}", table.file()),
                      fmt::format("{} = {} {}as in the table", name, there, in_all ? "" : "of all frames "),
                      fmt::format("{}", here[i]));
  }
}

void check_block_table(const CsvTable& blocks, const std::string& column, const CsvTable& table) {
  if (!blocks.has("block") || !blocks.has("run") || !blocks.has("frames"))
    throw bad_input({blocks.file()}, "the file has no blocks of frames", "a file written by average --blocks",
                    "no columns block, run, frames");
  if (blocks.rows() % table.rows() != 0 || blocks.rows() < 3 * table.rows())
    throw bad_input({blocks.file()}, fmt::format("the blocks are not those of {}", table.file()),
                    fmt::format("three times {} rows or more", table.rows()),
                    fmt::format("{}", blocks.rows()));
  for (const std::string_view name : {"r_inner", "r_outer", "phi_begin"})
    if (table.has(name)) check_same(blocks, table, std::string(name), true);
  check_same(blocks, table, "r", true);
  check_same(blocks, table, column, false);
}

// Each run may end with frames that do not fill a block.
void check_complete(const CsvTable& blocks, const ColumnWithoutBlocks& read, double all) {
  const std::set<std::int64_t> runs(read.runs.begin(), read.runs.end());
  const double in_blocks = read.frames * static_cast<double>(read.runs.size());
  if (all - in_blocks < read.frames * static_cast<double>(runs.size()) && all >= in_blocks) return;
  throw bad_input({blocks.file()}, "blocks are missing", fmt::format("blocks of {} frames in all", all),
                  fmt::format("{}", in_blocks));
}

void check_runs(const CsvTable& blocks, const ColumnWithoutBlocks& read, Eigen::Index volumes) {
  for (std::size_t i = 1; i < read.runs.size(); ++i)
    if (read.runs[i] < read.runs[i - 1])
      throw bad_input(blocks.row_place((static_cast<Eigen::Index>(i) + 1) * volumes), "runs are not in order",
                      fmt::format("run {} or more", read.runs[i - 1]), fmt::format("{}", read.runs[i]));
}

// The mean of the delete-one values equals that of all frames, except for ratios, by a fraction of their
// scatter s, and for the frames at the end of a run that are in no block; these scatter like blocks, by (m -
// 1) s. Ratios may deviate in a nearly empty ring; numbers that were scaled or inverted deviate in all rings.
void check_mean(const CsvTable& blocks, const std::string& column, const ColumnWithoutBlocks& read,
                const CsvTable& table, double all) {
  const Eigen::ArrayXd right = table.column(column);
  const auto m = static_cast<double>(read.values.cols());
  const double rest = 1 - read.frames * m / all;
  constexpr double rounding = 1e-9, of_ratios = 2, of_rest = 8;
  Eigen::Index judged = 0, astray = 0, first = -1;
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    const auto values = read.values.row(i);
    if (!values.isFinite().all() || !std::isfinite(right[i])) continue;
    const double scatter = std::sqrt((values - values.mean()).square().mean());
    const double allowed = rounding * std::abs(right[i]) + (of_ratios + of_rest * rest * (m - 1)) * scatter;
    ++judged;
    if (std::abs(values.mean() - right[i]) <= allowed) continue;
    ++astray;
    if (first < 0) first = i;
  }
  if (2 * astray <= judged) return;
  throw bad_input({blocks.file()},
                  fmt::format("{} without each block is not that of {}", column, table.file()),
                  fmt::format("a mean of {} in row {} as of all frames", right[first], first + 1),
                  fmt::format("{}", read.values.row(first).mean()));
}

}  // namespace

Table block_table(const Averager& averager, const TimeAverage& average) {
  const std::vector<Rows>& blocks = average.blocks();
  const auto count = static_cast<Eigen::Index>(blocks.size());
  if (count < 2) throw run_failed("too few frames for --blocks", "two frames or more", "one");
  Table table = averager.solve(average.mean());
  const Rows all = table.rows;
  table.columns.insert(table.columns.begin(), {{"block", "-", "-", "that is left out; 0: none, all frames"},
                                               {"run", "-", "-", "of the frames of the block"},
                                               {"frames", "-", "-", "in the block"}});
  table.rows.resize(all.rows() * (count + 1), all.cols() + own_columns);
  put(all, {0, 0, static_cast<double>(average.frames())}, 0, table.rows);
  Rows total = blocks.front();
  for (std::size_t i = 1; i < blocks.size(); ++i) total += blocks[i];
  for (Eigen::Index block = 0; block < count; ++block) {
    const auto i = static_cast<std::size_t>(block);
    const Table without = averager.solve((total - blocks[i]) / static_cast<double>(count - 1));
    put(without.rows,
        {static_cast<double>(block + 1), static_cast<double>(average.runs()[i] + 1),
         static_cast<double>(average.block_length())},
        block + 1, table.rows);
  }
  return table;
}

ColumnWithoutBlocks column_without_blocks(const CsvTable& blocks, const std::string& column,
                                          const CsvTable& table) {
  check_block_table(blocks, column, table);
  const Eigen::Index volumes = table.rows(), count = blocks.rows() / volumes - 1;
  const Eigen::ArrayXd number = blocks.column("block"), run = blocks.column("run"),
                       frames = blocks.column("frames"), value = blocks.column(column);
  ColumnWithoutBlocks result{Eigen::ArrayXXd(volumes, count), {}, 0};
  for (Eigen::Index block = 1; block <= count; ++block) {
    if (of_block(blocks, number, block, volumes) != static_cast<double>(block))
      throw bad_input(blocks.row_place(block * volumes), "blocks are not in order",
                      fmt::format("block {}", block), fmt::format("{}", number[block * volumes]));
    result.values.col(block - 1) = value.segment(block * volumes, volumes);
    result.runs.push_back(static_cast<std::int64_t>(of_block(blocks, run, block, volumes)));
    const double length = of_block(blocks, frames, block, volumes);
    if (block > 1 && length != result.frames)
      throw bad_input(blocks.row_place(block * volumes), "blocks differ in length",
                      fmt::format("{} frames", result.frames), fmt::format("{}", length));
    result.frames = length;
  }
  check_complete(blocks, result, frames[0]);
  check_runs(blocks, result, volumes);
  check_mean(blocks, column, result, table, frames[0]);
  return result;
}

}  // namespace mikromakro
