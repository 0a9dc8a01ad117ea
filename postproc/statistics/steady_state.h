// SPDX-License-Identifier: GPL-2.0-or-later
// From where on a series does not drift.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace mikromakro {

struct SteadyState {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr std::int64_t batch = 5;           ///< values of each batch
  static constexpr std::int64_t fewest = 8 * batch;  ///< values of a series
  static constexpr double most = 2;                  ///< of |change|/error

  std::int64_t begin = 0;  ///< first value of the rest
  double change = nan;     ///< over the rest, of the straight line through it
  double error = nan;      ///< standard error of the change; nan: correlated for too long to tell
  double two_tau = nan;    ///< correlation time of the rest about this line, in values

  bool steady() const;
};

/// MSER-5 (White2000): with z_1 ... z_k the means of successive batches of five values, the series is cut
/// behind the batch d <= k/2 that minimises
///     MSER(d) = 1/(k - d)^2 sum_{i > d} (z_i - mean of these)^2,
/// the squared standard error of the mean of the rest if its batches were independent.
///
/// The cut is best for any series, also for one that drifts to its end. So a straight line is fitted to the n
/// values of the rest by least squares; over the rest it changes by D, with the standard error
///     sqrt(12 (2 tau) s^2/n),
/// s and 2 tau (correlation_time.h) of the values about this line. The rest is steady if |D| is at most two
/// errors, which one in twenty steady series exceeds; otherwise the cut moves on, batch by batch, to the half
/// of the series at most. Throws std::invalid_argument on fewer than `fewest`
/// values. A series of equal values is steady from its beginning.
SteadyState steady_state(const std::vector<double>& series);

}  // namespace mikromakro
