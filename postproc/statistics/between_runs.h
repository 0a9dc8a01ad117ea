// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the means of several runs differ by more, or by less, than the fluctuations of their frames
// explain.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "statistics/correlation_time.h"

namespace mikromakro {

/// Means of the runs, one row per run.
struct RunMeans {
  Rows mean;
  Eigen::ArrayXd share;  ///< fraction of all values

  /// sum w^2 over the shares w.
  double squares() const { return share.square().sum(); }
  /// Degrees of freedom of the spread sum w (x - mean)^2 of values x that differ by their packings: its
  /// squared mean divided by half its variance, (1 - sum w^2)^2/(sum w^2 - 2 sum w^3 + (sum w^2)^2); the
  /// number of runs minus one for equal shares.
  double freedom() const;
  /// Variance of the mean of all values of each series, from the spread of the runs alone: sum w^2 sum w (x -
  /// mean)^2/(1 - sum w^2). It is correct if runs differ as packings do, and not too small if they differ
  /// only by the fluctuations of their frames.
  Eigen::ArrayXd variance_of_mean() const;
};

/// Rows of `series` are times; the values of one run are contiguous.
RunMeans run_means(const Rows& series, const std::vector<std::int64_t>& runs);

struct BetweenRuns {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CorrelationTime within;           ///< 2 tau about the mean of each run
  double chi_square = nan;          ///< per value: 1 if the frames explain it; nan for one run, or unknown
  double chance = nan;              ///< probability of a chi_square at least as large in that case
  double chance_of_near = nan;      ///< probability that two of the runs are as close as the closest two
  Eigen::ArrayXd chance_of_series;  ///< `chance` for each series alone; empty if unknown

  /// By far more than their frames explain.
  bool differ() const { return chance < 0.01; }
  /// The same of one series among many, which leave chi_square near 1.
  bool differs(Eigen::Index series) const {
    return chance_of_series.size() > 0 && chance_of_series[series] < 0.01;
  }
  /// So close that two of the runs must contain the same frames.
  bool repeat() const { return chance_of_near < 1e-4; }
};

/// chi^2 = sum_r n_r (m_r - m)^2/(2 tau s^2)/(runs - 1), averaged over the series. The variance s^2 and 2 tau
/// are taken about the mean m_r of each run: about the common mean, a run that is offset as a whole would be
/// correlated with itself at all lags, and its offset would cancel from chi^2. s^2 = sum (x - m_r)^2/(n -
/// runs 2 tau), corrected for the subtracted means. For one series chi^2 is distributed as F with runs - 1
/// and nu = (n - runs)/sum rho_k^2 degrees of freedom, with mean nu/(nu - 2), by which it is divided. The
/// mean over `independent_series` has the variance for one of them divided by their number, plus that of 2
/// tau, which they share; probabilities are those of F with these two variances.
BetweenRuns between_runs(const Rows& series, const std::vector<std::int64_t>& runs);

}  // namespace mikromakro
