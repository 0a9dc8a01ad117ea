// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/comparison_report.h"
#include "averaging/comparison.h"

namespace mikromakro {
namespace {

// A relative difference, and where it was found.
struct Found {
  double relative = 0;
  std::string where;
  std::size_t weight = 0;
};

using List = std::vector<Found>;

void add(const Difference& difference, double rms, const std::string& where, std::size_t weight, List& list) {
  const double relative = difference.mean / rms;
  if (std::isfinite(relative)) list.push_back({relative, where, weight});
}

double median_of(List list) {
  if (list.empty()) return std::nan("");
  const auto middle = list.begin() + std::ssize(list) / 2;
  const auto less = [](const Found& one, const Found& other) { return one.relative < other.relative; };
  std::nth_element(list.begin(), middle, list.end(), less);
  if (list.size() % 2 == 1) return middle->relative;
  return 0.5 * (middle->relative + std::max_element(list.begin(), middle, less)->relative);
}

std::string largest_of(const List& list) {
  if (list.empty()) return "none is defined";
  const Found& most = *std::max_element(list.begin(), list.end(), [](const Found& one, const Found& other) {
    return one.relative < other.relative;
  });
  return fmt::format("{:.2g}, {}", most.relative, most.where);
}

List between_weights(const Comparison& comparison) {
  List list;
  for (std::size_t column = 0; column < comparison.columns.size(); ++column)
    for (std::size_t r = 0; r < comparison.resolutions.size(); ++r) {
      const Eigen::ArrayXd reference = column_of(comparison, comparison.at(r, 0).table.rows, column);
      for (std::size_t w = 1; w < comparison.weights.size(); ++w) {
        const Difference found = difference(column_of(comparison, comparison.at(r, w).table.rows, column),
                                            reference, comparison.columns[column].period);
        add(found, found.rms,
            fmt::format("{} by {} at {}", comparison.columns[column].name, comparison.weights[w],
                        comparison.resolutions[r]),
            w, list);
      }
    }
  return list;
}

struct BetweenResolutions {
  List sums, hidden;
};

BetweenResolutions between_resolutions(const Comparison& comparison) {
  BetweenResolutions both;
  const auto width = static_cast<Eigen::Index>(comparison.columns.size());
  const std::vector<std::size_t> order = ascending(comparison.resolutions);
  for (std::size_t pair = 1; pair < order.size(); ++pair)
    for (std::size_t w = 0; w < comparison.weights.size(); ++w) {
      const Table& coarse = comparison.at(order[pair - 1], w).table;
      const Table& fine = comparison.at(order[pair], w).table;
      const Rows summed = averaged_onto(coarse, fine, width), spread = averaged_onto(fine, coarse, width);
      for (std::size_t column = 0; column < comparison.columns.size(); ++column) {
        if (!comparison.volume_sums[column]) continue;
        const std::string where =
            fmt::format("{} by {}, {} in {}", comparison.columns[column].name, comparison.weights[w],
                        comparison.resolutions[order[pair]], comparison.resolutions[order[pair - 1]]);
        const Difference sums =
            difference(column_of(comparison, summed, column), column_of(comparison, coarse.rows, column));
        add(sums, sums.rms, where, w, both.sums);
        add(difference(column_of(comparison, fine.rows, column), column_of(comparison, spread, column)),
            sums.rms, where, w, both.hidden);
      }
    }
  return both;
}

std::string medians(const Comparison& comparison, const List& list) {
  std::vector<std::string> words;
  for (std::size_t w = 1; w < comparison.weights.size(); ++w) {
    List own;
    std::copy_if(list.begin(), list.end(), std::back_inserter(own),
                 [&](const Found& found) { return found.weight == w; });
    words.push_back(fmt::format("{} {:.2g}", comparison.weights[w], median_of(own)));
  }
  return words.empty() ? "one weight" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string summary_of(const Comparison& comparison) {
  const List weights = between_weights(comparison);
  const BetweenResolutions resolutions = between_resolutions(comparison);
  const bool one = resolutions.sums.empty();
  const std::string none = "one resolution, or no columns that are sums over V";
  return fmt::format(
      "summary: {} columns, resolutions {}; mean differences over the rms of {}\n"
      "  weights, median of the columns:  {}\n"
      "  weights, most:                   {}\n"
      "  fine ones add up to coarse ones: {}\n"
      "  coarse ones hide:                {}\n",
      comparison.columns.size(), fmt::join(comparison.resolutions, ","), comparison.weights.front(),
      medians(comparison, weights), comparison.weights.size() < 2 ? "one weight" : largest_of(weights),
      one ? none : "to " + largest_of(resolutions.sums),
      one ? none
          : fmt::format("{:.2g} in the median, most {}", median_of(resolutions.hidden),
                        largest_of(resolutions.hidden)));
}

}  // namespace mikromakro
