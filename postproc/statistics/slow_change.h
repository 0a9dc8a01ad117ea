// SPDX-License-Identifier: GPL-2.0-or-later
// Detects changes that are slower than the correlation time of the series suggests.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "statistics/correlation_time.h"

namespace mikromakro {

struct SlowChange {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double ratio = nan;   ///< squared slowest wave relative to the next four; 1 if nothing is slow
  double chance = nan;  ///< probability of a ratio at least as large in that case

  bool shows() const { return chance < 0.01; }
};

/// The waves c_k = sqrt(2/n) sum x_i cos(pi k (i + 1/2)/n) of a run of n values all have, for small k, the
/// variance 2 tau s^2 if nothing is slower than the window of 2 tau. A change that lasts as long as the run
/// makes the slowest wave, k = 1, larger than those with k = 2 ... 5, and the mean, which would be k = 0,
/// even more so. The waves are independent of the mean, so a decision based on them does not favour means
/// that are close to the true value.
///
/// The squares are summed over runs of at least ten 2 tau, each series in units of its variance; with G
/// independent series in R such runs, their ratio is distributed as F with G R and 4 G R degrees of freedom.
/// A single series is therefore almost useless.
SlowChange slow_change(const Rows& series, const std::vector<std::int64_t>& runs,
                       const CorrelationTime& time);

}  // namespace mikromakro
