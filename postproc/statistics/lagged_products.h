// SPDX-License-Identifier: GPL-2.0-or-later
// Products of values of series that stand some time apart.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// Of series around their means, each divided by its standard deviation. Pairs of different runs do not
/// count. What is said of all series is told by a thousand of them at most, which stand evenly among all:
/// they are enough, and large grids cost no more.
class LaggedProducts {
 public:
  /// A row for each time, a column for each series, which must fluctuate.
  LaggedProducts(Rows series, const std::vector<std::int64_t>& runs);

  double count() const { return static_cast<double>(deviation_.rows()); }  ///< of times
  /// The longest lag that counts: a quarter of the series, shorter than the longest run.
  Eigen::Index longest() const { return longest_; }
  double longest_run() const { return static_cast<double>(longest_run_); }
  /// Whether there are no pairs beyond the longest lag.
  bool all_lags() const { return longest_ + 1 == longest_run_; }

  double pairs(Eigen::Index lag) const;
  /// Mean over the pairs and all series, made when it is asked for first; 1 for the lag 0.
  double mean(Eigen::Index lag);
  /// Of each series, the sum over all pairs of times, either way, that are at most `lag` apart, over count^2.
  Eigen::ArrayXd sums_of_series(Eigen::Index lag) const;

  /// How many independent series fluctuate as these do together: G/(1 + (G - 1) r^2), r^2 the mean square of
  /// the correlation of two of them, less what independent ones have, `squares`/count.
  double independent_series(double squares) const;
  /// Mean square of the skewness of the series.
  double square_skewness() const { return some_.array().cube().rowwise().mean().square().mean(); }

 private:
  double sum(Eigen::Index lag) const;

  Rows deviation_;
  Eigen::MatrixXd some_;  // of them, a row for each series
  std::vector<Eigen::Index> run_lengths_;
  Eigen::Index longest_run_ = 0, longest_ = 0;
  std::vector<double> mean_;
  double square_correlation_ = 0;  // of two different ones, on average
};

}  // namespace mikromakro
