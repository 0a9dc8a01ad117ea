// SPDX-License-Identifier: GPL-2.0-or-later
// Lagged products of time series.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// The mean that is subtracted from series: that of all values, or that of each run. About a common mean, a
/// run that is offset as a whole is correlated with itself at all lags.
enum class About { common_mean, own_means };

/// Products of series about their means, each divided by its standard deviation. Pairs across different runs
/// do not count. Averages over the series use at most a thousand of them, evenly spread, which suffice and
/// keep large grids cheap.
class LaggedProducts {
 public:
  /// One row per time, one column per series; every series must fluctuate.
  LaggedProducts(Rows series, const std::vector<std::int64_t>& runs, About about = About::common_mean);

  double count() const { return static_cast<double>(deviation_.rows()); }  ///< number of times
  /// The longest lag used: a quarter of the series, but shorter than the longest run; about own means at most
  /// half of the longest run.
  Eigen::Index longest() const { return longest_; }
  double longest_run() const { return static_cast<double>(longest_run_); }
  /// Whether there are no pairs beyond the longest lag.
  bool all_lags() const { return longest_ + 1 == longest_run_; }

  double pairs(Eigen::Index lag) const;
  /// Fraction of the variance of the mean of all values that is missing in the products at a lag because
  /// means were subtracted: 1 for the common mean; sum_r (n_r - k)/n_r n/N_k for means of runs of n_r values.
  double missing(Eigen::Index lag) const;
  /// Mean over the pairs and all series, computed on first use; 1 at lag 0.
  double mean(Eigen::Index lag);
  /// For each series, the sum over all ordered pairs of times at most `lag` apart, divided by count^2.
  Eigen::ArrayXd sums_of_series(Eigen::Index lag) const;

  /// Number of independent series equivalent to these: G/(1 + (G - 1) r^2), with r^2 the mean squared
  /// correlation between two of them, minus the value `squares`/count of independent series.
  double independent_series(double squares) const;
  /// Mean squared skewness of the series.
  double square_skewness() const { return some_.array().cube().rowwise().mean().square().mean(); }

 private:
  LaggedProducts(const std::vector<Eigen::Index>& run_lengths, Rows series, About about);
  double sum(Eigen::Index lag) const;

  About about_;
  Rows deviation_;
  Eigen::MatrixXd some_;  // a sample of them, one row per series
  std::vector<Eigen::Index> run_lengths_;
  Eigen::Index longest_run_ = 0, longest_ = 0;
  std::vector<double> mean_;
  double square_correlation_ = 0;  // mean over pairs of different series
};

}  // namespace mikromakro
