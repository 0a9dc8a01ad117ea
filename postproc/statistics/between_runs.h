// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the means of several runs differ by more, or by less, than their frames tell.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "statistics/correlation_time.h"

namespace mikromakro {

/// Of each run, a row per run.
struct RunMeans {
  Rows mean;
  Eigen::ArrayXd share;  ///< of all values

  /// sum w^2 over the shares w.
  double squares() const { return share.square().sum(); }
  /// Of the spread sum w (x - mean)^2 of values x that differ by their packings: its squared mean over half
  /// of its variance, (1 - sum w^2)^2/(sum w^2 - 2 sum w^3 + (sum w^2)^2); runs less one for equal shares.
  double freedom() const;
  /// Of the mean of all values of each series, from the spread of the runs alone: sum w^2 sum w (x -
  /// mean)^2/(1 - sum w^2). It is right if runs differ as packings do, and not too small if they differ by
  /// their frames only.
  Eigen::ArrayXd variance_of_mean() const;
};

/// Rows of `series` are times; the values of one run are contiguous.
RunMeans run_means(const Rows& series, const std::vector<std::int64_t>& runs);

struct BetweenRuns {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CorrelationTime within;   ///< 2 tau about the mean of each run
  double chi_square = nan;  ///< per value: 1 if runs differ as their frames tell; nan for one run, or unknown
  double chance = nan;      ///< of as large a chi_square if they do
  double chance_of_near = nan;  ///< of two of the runs that are as near to each other as the nearest two

  /// By far more than their frames tell.
  bool differ() const { return chance < 0.01; }
  /// By so much less that two of them hold the same frames.
  bool repeat() const { return chance_of_near < 1e-4; }
};

/// chi^2 = sum_r n_r (m_r - m)^2/(2 tau s^2)/(runs - 1), its mean over the series. Variance s^2 and 2 tau are
/// those about the mean m_r of each run: about the common mean, a run that is off as a whole would be
/// correlated with itself at all lags, and its distance would divide itself out. s^2 = sum (x - m_r)^2/(n -
/// runs 2 tau), for what the means took away. For one series chi^2 is distributed as F with runs - 1 and nu =
/// (n - runs)/sum rho_k^2 degrees of freedom, of mean nu/(nu - 2), by which it is divided. The mean over
/// `independent_series` has the variance of one of them divided by their number, and that of 2 tau, which
/// they share; chances are those of F of these two variances.
BetweenRuns between_runs(const Rows& series, const std::vector<std::int64_t>& runs);

}  // namespace mikromakro
