// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/window_rows.h"

#include <utility>

namespace mikromakro {
namespace {

// The part of a table that describes the volumes.
Eigen::Index coordinate_columns(const Averager& averager, const Table& solved) {
  return std::ssize(solved.columns) - std::ssize(averager.columns());
}

}  // namespace

std::vector<Column> window_columns(bool runs) {
  std::vector<Column> columns = {{"step", "-", "-", "mean time step of the frames of the window"},
                                 {"time", "s", "-", "mean time of the frames of the window"},
                                 {"step_first", "-", "-", "first time step of the window"},
                                 {"step_last", "-", "-", "last time step of the window"}};
  if (runs) columns.push_back({"run", "-", "-", "of the frames of the window, from 1"});
  return columns;
}

Eigen::ArrayXd window_numbers(const Window& window, bool runs) {
  Eigen::ArrayXd numbers(runs ? 5 : 4);
  numbers.head<4>() << window.step, window.time, static_cast<double>(window.first_step),
      static_cast<double>(window.last_step);
  if (runs) numbers[4] = static_cast<double>(window.run + 1);
  return numbers;
}

WindowRows::WindowRows(const Averager& averager, WindowColumns columns)
    : averager_(averager), columns_(std::move(columns)) {}

SeriesColumns WindowRows::columns() const {
  SeriesColumns all;
  all.of_window = window_columns(columns_.runs);
  for (const WallNumbers& wall : columns_.walls)
    all.of_window.insert(all.of_window.end(), wall.columns.begin(), wall.columns.end());
  const Table volumes = averager_.volumes();
  all.of_volume = volumes.columns;
  all.volumes = volumes.rows;
  all.values = averager_.columns();
  if (!columns_.errors) return all;
  for (Column& column : error_columns(averager_.columns(), averager_.columns_of_fields()))
    all.values.push_back(std::move(column));
  return all;
}

WindowRows::Of WindowRows::of(const Window& window) const {
  Of rows;
  const Eigen::ArrayXd own = window_numbers(window, columns_.runs);
  rows.numbers.resize(own.size() + window.walls.size());
  rows.numbers << own, window.walls;
  Table table = averager_.solve(window.sums.mean());
  const Eigen::Index coordinates = coordinate_columns(averager_, table);
  if (columns_.errors) {
    rows.errors = block_errors(
        window.sums, [&](const Rows& mean) { return averager_.values(mean); }, averager_.columns_of_fields());
    append_errors(rows.errors, averager_.columns(), table);
  }
  rows.values = table.rows.rightCols(table.rows.cols() - coordinates);
  return rows;
}

}  // namespace mikromakro
