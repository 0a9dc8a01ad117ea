// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "averaging/comparison.h"

namespace mikromakro {
namespace {

// Column widths of the text output, which fit the longest names.
struct Widths {
  std::size_t name = 6;
  std::size_t unit = 4;
  std::size_t weight = 6;
};

Widths widths_of(const Comparison& comparison) {
  Widths widths;
  for (const Column& column : comparison.columns) {
    widths.name = std::max(widths.name, column.name.size());
    widths.unit = std::max(widths.unit, column.unit.size());
  }
  for (const std::string& weight : comparison.weights) widths.weight = std::max(widths.weight, weight.size());
  return widths;
}

std::string relative(double difference, double rms) {
  return fmt::format("{:>11.3e}", difference / rms);
}

}  // namespace

Eigen::ArrayXd column_of(const Comparison& comparison, const Rows& rows, std::size_t column) {
  const std::size_t from_end = comparison.columns.size() - column;
  return rows.col(rows.cols() - static_cast<Eigen::Index>(from_end));
}

std::vector<std::size_t> ascending(const std::vector<int>& resolutions) {
  std::vector<std::size_t> order(resolutions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return resolutions[a] < resolutions[b]; });
  return order;
}

std::string differences_of_weights(const Comparison& comparison) {
  const Widths widths = widths_of(comparison);
  std::string text = fmt::format("differences from the weight {}\n", comparison.weights.front());
  fmt::format_to(std::back_inserter(text),
                 "{:<{}} {:<{}} resolution {:<{}} {:>11} {:>11} {:>11} {:>11}  undefined\n", "column",
                 widths.name, "unit", widths.unit, "weight", widths.weight, "mean", "largest", "mean/rms",
                 "largest/rms");
  for (std::size_t column = 0; column < comparison.columns.size(); ++column) {
    for (std::size_t r = 0; r < comparison.resolutions.size(); ++r) {
      const Eigen::ArrayXd reference = column_of(comparison, comparison.at(r, 0).table.rows, column);
      for (std::size_t w = 1; w < comparison.weights.size(); ++w) {
        const Difference found = difference(column_of(comparison, comparison.at(r, w).table.rows, column),
                                            reference, comparison.columns[column].period);
        fmt::format_to(std::back_inserter(text),
                       "{:<{}} {:<{}} {:>10} {:<{}} {:>11.3e} {:>11.3e} {} {}  {} of {}\n",
                       comparison.columns[column].name, widths.name, comparison.columns[column].unit,
                       widths.unit, comparison.resolutions[r], comparison.weights[w], widths.weight,
                       found.mean, found.largest, relative(found.mean, found.rms),
                       relative(found.largest, found.rms), found.missing, reference.size());
      }
    }
  }
  return text;
}

std::string differences_of_resolutions(const Comparison& comparison) {
  const Widths widths = widths_of(comparison);
  const auto width = static_cast<Eigen::Index>(comparison.columns.size());
  const std::vector<std::size_t> order = ascending(comparison.resolutions);
  std::string lines;
  for (std::size_t pair = 1; pair < order.size(); ++pair) {
    for (std::size_t w = 0; w < comparison.weights.size(); ++w) {
      const Table& coarse = comparison.at(order[pair - 1], w).table;
      const Table& fine = comparison.at(order[pair], w).table;
      const Rows summed = averaged_onto(coarse, fine, width);
      const Rows spread = averaged_onto(fine, coarse, width);
      for (std::size_t column = 0; column < comparison.columns.size(); ++column) {
        if (!comparison.volume_sums[column]) continue;
        const Difference sums =
            difference(column_of(comparison, summed, column), column_of(comparison, coarse.rows, column));
        const Difference hidden =
            difference(column_of(comparison, fine.rows, column), column_of(comparison, spread, column));
        fmt::format_to(std::back_inserter(lines), "{:<{}} {:<{}} {:>6} {:>6} {} {} {} {}\n",
                       comparison.columns[column].name, widths.name, comparison.weights[w], widths.weight,
                       comparison.resolutions[order[pair - 1]], comparison.resolutions[order[pair]],
                       relative(sums.mean, sums.rms), relative(sums.largest, sums.rms),
                       relative(hidden.mean, sums.rms), relative(hidden.largest, sums.rms));
      }
    }
  }
  if (lines.empty()) return {};
  return fmt::format(
             "differences of resolutions over the rms of the coarse one: fine averages added up to coarse "
             "volumes "
             "(sum), and in them (within)\n{:<{}} {:<{}} coarse   fine {:>11} {:>11} {:>11} {:>11}\n",
             "column", widths.name, "weight", widths.weight, "sum mean", "sum largest", "within mean",
             "w. largest") +
         lines;
}

std::string long_head(const Preamble& preamble, const Comparison& comparison,
                      const std::vector<Column>& leading) {
  Table head;
  head.columns = leading;
  head.columns.push_back({"weight", "-", "-", "how discs count"});
  head.columns.push_back({"resolution", "1", "-", "number of rings, or of columns of rectangles"});
  const std::vector<Column>& columns = comparison.profiles.front().table.columns;
  head.columns.insert(head.columns.end(), columns.begin(), columns.end());
  return csv_text(preamble, head);
}

std::string long_rows(const Comparison& comparison, const Eigen::ArrayXd& leading) {
  std::string begin, text;
  for (const double number : leading) begin.append(number_text(number)) += ',';
  for (const Profile& profile : comparison.profiles) {
    for (Eigen::Index row = 0; row < profile.table.rows.rows(); ++row) {
      fmt::format_to(std::back_inserter(text), "{}{},{}", begin, profile.weight, profile.resolution);
      for (const double number : profile.table.rows.row(row)) text.append(",").append(number_text(number));
      text += '\n';
    }
  }
  return text;
}

std::string long_csv(const Preamble& preamble, const Comparison& comparison) {
  return long_head(preamble, comparison, {}) + long_rows(comparison, {});
}

}  // namespace mikromakro
