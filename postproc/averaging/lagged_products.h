// Products of values of series that stand some time apart.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

namespace mikromakro {

/// Of series around their means, each divided by its standard deviation; made lag by lag as they are asked
/// for. Pairs of different runs do not count.
class LaggedProducts {
 public:
  /// A row for each time, a column for each series, which must fluctuate.
  LaggedProducts(const Eigen::ArrayXXd& series, const std::vector<std::int64_t>& runs);

  double count() const { return static_cast<double>(deviation_.rows()); }  ///< of times
  Eigen::Index series() const { return deviation_.cols(); }
  /// The longest lag that counts: a quarter of the series, shorter than the longest run.
  Eigen::Index longest() const { return longest_; }
  double longest_run() const { return static_cast<double>(longest_run_); }
  /// Whether there are no pairs beyond the longest lag.
  bool all_lags() const { return longest_ + 1 == longest_run_; }

  double pairs(Eigen::Index lag) const;
  /// Mean over the pairs of each series; 1 for the lag 0.
  const Eigen::ArrayXd& of_series(Eigen::Index lag);
  /// And over all series.
  double mean(Eigen::Index lag);

  /// How many independent series fluctuate as these do together: G/(1 + (G - 1) r^2), r^2 the mean square of
  /// the correlation of two of them (of 200 at most), less what independent ones have, `squares`/count.
  double independent_series(double squares) const;

 private:
  Eigen::ArrayXXd deviation_;
  std::vector<Eigen::Index> run_lengths_;
  Eigen::Index longest_run_ = 0, longest_ = 0;
  std::vector<Eigen::ArrayXd> of_series_;
  std::vector<double> mean_;
  double square_correlation_ = 0;  // of two different series
};

}  // namespace mikromakro
