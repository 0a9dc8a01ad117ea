// SPDX-License-Identifier: GPL-2.0-or-later
// Which intervals between ascending edges something reaches into.
#pragma once

#include <algorithm>
#include <vector>

namespace mikromakro {

/// From the first to before the last.
struct Intervals {
  int first;
  int last;
};

/// Those that have more than an end in common with [low, high]; none where both are equal.
inline Intervals reached_intervals(const std::vector<double>& edges, double low, double high) {
  const auto first = std::upper_bound(edges.begin() + 1, edges.end(), low) - edges.begin() - 1;
  const auto last = std::lower_bound(edges.begin(), edges.end() - 1, high) - edges.begin();
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace mikromakro
