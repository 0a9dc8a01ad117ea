// SPDX-License-Identifier: GPL-2.0-or-later
// The intervals between ascending edges that a range overlaps.
#pragma once

#include <algorithm>
#include <vector>

namespace mikromakro {

/// Half-open index range: first <= i < last.
struct Intervals {
  int first;
  int last;
};

/// The intervals that share more than an end point with [low, high]; none if low == high.
inline Intervals reached_intervals(const std::vector<double>& edges, double low, double high) {
  const auto first = std::upper_bound(edges.begin() + 1, edges.end(), low) - edges.begin() - 1;
  const auto last = std::lower_bound(edges.begin(), edges.end() - 1, high) - edges.begin();
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace mikromakro
