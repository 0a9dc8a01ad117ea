// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/lagged_products.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mikromakro {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

// Calls work(first, count) for bundles of series that fit the cache.
template <typename Do>
void in_bundles(Eigen::Index count, Do work) {
  constexpr Eigen::Index bundle = 256;
  for (Eigen::Index first = 0; first < count; first += bundle) work(first, std::min(bundle, count - first));
}

Rows standardised(Rows series) {
  in_bundles(series.cols(), [&](Eigen::Index first, Eigen::Index count) {
    auto some = series.middleCols(first, count);
    const Row mean = some.colwise().mean();
    some.rowwise() -= mean;
    const Row inverse = some.square().colwise().mean().rsqrt();
    some.rowwise() *= inverse;
  });
  return series;
}

Eigen::MatrixXd some_of(const Rows& series) {
  constexpr Eigen::Index most = 1000;
  const Eigen::Index count = std::min(most, series.cols());
  Eigen::MatrixXd some(count, series.rows());
  for (Eigen::Index i = 0; i < count; ++i) some.row(i) = series.col(i * series.cols() / count);
  return some;
}

// The sum of squared correlations over all pairs of series equals that of the squared products over all pairs
// of times.
double mean_square_correlation(const Eigen::MatrixXd& series) {
  const auto count = static_cast<double>(series.rows());
  if (count < 2) return 0;
  Eigen::MatrixXd products;
  if (series.rows() < series.cols()) {
    products = series * series.transpose();
  } else {
    products = series.transpose() * series;
  }
  return (products.squaredNorm() / std::pow(static_cast<double>(series.cols()), 2) - count) /
         (count * (count - 1));
}

}  // namespace

LaggedProducts::LaggedProducts(Rows series, const std::vector<std::int64_t>& runs)
    : deviation_(standardised(std::move(series))),
      some_(some_of(deviation_)),
      square_correlation_(mean_square_correlation(some_)) {
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

double LaggedProducts::sum(Eigen::Index lag) const {
  double sum = 0;
  Eigen::Index begin = 0;
  for (const Eigen::Index length : run_lengths_) {
    if (const Eigen::Index pairs = length - lag; pairs > 0)
      sum += some_.middleCols(begin, pairs).cwiseProduct(some_.middleCols(begin + lag, pairs)).sum();
    begin += length;
  }
  return sum;
}

double LaggedProducts::mean(Eigen::Index lag) {
  while (static_cast<Eigen::Index>(mean_.size()) <= lag) {
    const auto next = static_cast<Eigen::Index>(mean_.size());
    mean_.push_back(sum(next) / pairs(next) / static_cast<double>(some_.rows()));
  }
  return mean_[static_cast<std::size_t>(lag)];
}

Eigen::ArrayXd LaggedProducts::sums_of_series(Eigen::Index lag) const {
  Eigen::ArrayXd sums(deviation_.cols());
  in_bundles(sums.size(), [&](Eigen::Index first, Eigen::Index count) {
    Row sum = Row::Zero(count);
    Eigen::Index begin = 0;
    for (const Eigen::Index length : run_lengths_) {
      const auto run = deviation_.block(begin, first, length, count);
      Row near = run.topRows(std::min(lag, length)).colwise().sum();
      for (Eigen::Index i = 0; i < length; ++i) {
        if (i + lag < length) near += run.row(i + lag);
        if (i > lag) near -= run.row(i - lag - 1);
        sum += near * run.row(i);
      }
      begin += length;
    }
    sums.segment(first, count) = sum.transpose();
  });
  return sums / (this->count() * this->count());
}

double LaggedProducts::independent_series(double squares) const {
  constexpr double most = 0.9;  // upper bound for short series
  const auto series = static_cast<double>(some_.rows());
  const double by_chance = std::min(squares / count(), most);
  const double beyond = std::max(0.0, (square_correlation_ - by_chance) / (1 - by_chance));
  return series / (1 + (series - 1) * beyond);
}

}  // namespace mikromakro
