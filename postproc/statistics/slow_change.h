// SPDX-License-Identifier: GPL-2.0-or-later
// Whether series change more slowly than their correlation time tells.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "statistics/correlation_time.h"

namespace mikromakro {

struct SlowChange {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double ratio = nan;   ///< square of the slowest wave over those of the next four; 1 if nothing is slow
  double chance = nan;  ///< of as large a ratio then

  bool shows() const { return chance < 0.01; }
};

/// The waves c_k = sqrt(2/n) sum x_i cos(pi k (i + 1/2)/n) that fit into a run of n values are, for small k,
/// all of the variance 2 tau s^2 if nothing is slower than the window of 2 tau. What lasts as long as the run
/// makes the slowest one, k = 1, larger than those of k = 2 ... 5, and the mean, which would be k = 0, even
/// more so. They are independent of the mean, so that a decision by them does not favour means that are near
/// the truth.
///
/// The squares are summed over runs of ten 2 tau or more, each series in units of its variance; with G
/// independent series in R such runs, their ratio is distributed as F with G R and 4 G R degrees of freedom.
/// A single series thus says next to nothing.
SlowChange slow_change(const Rows& series, const std::vector<std::int64_t>& runs,
                       const CorrelationTime& time);

}  // namespace mikromakro
