// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/lagged_products.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mikromakro {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

// Calls work(first, count) for bundles of series that fit into the cache.
template <typename Do>
void in_bundles(Eigen::Index count, Do work) {
  constexpr Eigen::Index bundle = 256;
  for (Eigen::Index first = 0; first < count; first += bundle) work(first, std::min(bundle, count - first));
}

std::vector<Eigen::Index> lengths_of(const std::vector<std::int64_t>& runs) {
  std::vector<Eigen::Index> lengths;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i == 0 || runs[i] != runs[i - 1]) lengths.push_back(0);
    ++lengths.back();
  }
  return lengths;
}

// Standardised about the mean of each of these stretches.
Rows standardised(Rows series, const std::vector<Eigen::Index>& stretches) {
  in_bundles(series.cols(), [&](Eigen::Index first, Eigen::Index count) {
    auto some = series.middleCols(first, count);
    Eigen::Index begin = 0;
    for (const Eigen::Index length : stretches) {
      auto stretch = some.middleRows(begin, length);
      const Row mean = stretch.colwise().mean();
      stretch.rowwise() -= mean;
      begin += length;
    }
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

LaggedProducts::LaggedProducts(Rows series, const std::vector<std::int64_t>& runs, About about)
    : LaggedProducts(lengths_of(runs), std::move(series), about) {}

LaggedProducts::LaggedProducts(const std::vector<Eigen::Index>& run_lengths, Rows series, About about)
    : about_(about),
      deviation_(standardised(std::move(series), about == About::own_means
                                                     ? run_lengths
                                                     : std::vector<Eigen::Index>{series.rows()})),
      some_(some_of(deviation_)),
      run_lengths_(run_lengths),
      longest_run_(*std::max_element(run_lengths.begin(), run_lengths.end())),
      square_correlation_(mean_square_correlation(some_)) {
  longest_ = std::min(deviation_.rows() / 4, longest_run_ - 1);
  if (about_ == About::own_means) longest_ = std::min(longest_, longest_run_ / 2);
}

double LaggedProducts::pairs(Eigen::Index lag) const {
  Eigen::Index pairs = 0;
  for (const Eigen::Index length : run_lengths_) pairs += std::max(length - lag, Eigen::Index{0});
  return static_cast<double>(pairs);
}

double LaggedProducts::missing(Eigen::Index lag) const {
  if (about_ == About::common_mean) return 1;
  double shares = 0;
  for (const Eigen::Index length : run_lengths_)
    shares += static_cast<double>(std::max(length - lag, Eigen::Index{0})) / static_cast<double>(length);
  return shares * count() / pairs(lag);
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
