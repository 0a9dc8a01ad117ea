#include "averaging/lagged_products.h"

#include <algorithm>
#include <cmath>

namespace mikromakro {
namespace {

Eigen::ArrayXXd standardised(const Eigen::ArrayXXd& series) {
  Eigen::ArrayXXd deviation = series.rowwise() - series.colwise().mean();
  for (auto column : deviation.colwise()) column /= std::sqrt(column.square().mean());
  return deviation;
}

// Mean of r^2 of two different series, of some that stand evenly among all.
double mean_square_correlation(const Eigen::ArrayXXd& deviation) {
  constexpr Eigen::Index most = 200;
  const Eigen::Index count = std::min(most, deviation.cols());
  if (count < 2) return 0;
  Eigen::MatrixXd some(deviation.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) some.col(i) = deviation.col(i * deviation.cols() / count);
  const Eigen::MatrixXd correlation = some.transpose() * some / static_cast<double>(deviation.rows());
  const auto pairs = static_cast<double>(count * (count - 1));
  return (correlation.squaredNorm() - static_cast<double>(count)) / pairs;
}

}  // namespace

LaggedProducts::LaggedProducts(const Eigen::ArrayXXd& series, const std::vector<std::int64_t>& runs)
    : deviation_(standardised(series)), square_correlation_(mean_square_correlation(deviation_)) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i == 0 || runs[i] != runs[i - 1]) run_lengths_.push_back(0);
    longest_run_ = std::max(longest_run_, ++run_lengths_.back());
  }
  longest_ = std::min(deviation_.rows() / 4, longest_run_ - 1);
}

double LaggedProducts::pairs(Eigen::Index lag) const {
  Eigen::Index pairs = 0;
  for (const Eigen::Index length : run_lengths_) pairs += std::max(length - lag, Eigen::Index{0});
  return static_cast<double>(pairs);
}

const Eigen::ArrayXd& LaggedProducts::of_series(Eigen::Index lag) {
  while (static_cast<Eigen::Index>(of_series_.size()) <= lag) {
    const auto next = static_cast<Eigen::Index>(of_series_.size());
    Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(series());
    Eigen::Index begin = 0;
    for (const Eigen::Index length : run_lengths_) {
      if (const Eigen::Index pairs = length - next; pairs > 0)
        sums += (deviation_.middleRows(begin, pairs) * deviation_.middleRows(begin + next, pairs))
                    .colwise()
                    .sum()
                    .transpose();
      begin += length;
    }
    of_series_.emplace_back(sums / pairs(next));
    mean_.push_back(of_series_.back().mean());
  }
  return of_series_[static_cast<std::size_t>(lag)];
}

double LaggedProducts::mean(Eigen::Index lag) {
  of_series(lag);
  return mean_[static_cast<std::size_t>(lag)];
}

double LaggedProducts::independent_series(double squares) const {
  constexpr double most = 0.9;  // of short series
  const double by_chance = std::min(squares / count(), most);
  const double beyond = std::max(0.0, (square_correlation_ - by_chance) / (1 - by_chance));
  return static_cast<double>(series()) / (1 + static_cast<double>(series() - 1) * beyond);
}

}  // namespace mikromakro
