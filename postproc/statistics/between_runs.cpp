// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/between_runs.h"

#include <algorithm>
#include <cmath>

#include "statistics/f_distribution.h"

namespace mikromakro {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

struct Lengths {
  std::vector<Eigen::Index> begins;  // first value of each run, then the end of the last run

  explicit Lengths(const std::vector<std::int64_t>& runs) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (i == 0 || runs[i] != runs[i - 1]) begins.push_back(static_cast<Eigen::Index>(i));
    begins.push_back(static_cast<Eigen::Index>(runs.size()));
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(begins.size()) - 1; }
  Eigen::Index begin(Eigen::Index run) const { return begins[static_cast<std::size_t>(run)]; }
  Eigen::Index of(Eigen::Index run) const { return begin(run + 1) - begin(run); }
};

// The series that change within a run beyond rounding; all others change only from run to run.
std::vector<Eigen::Index> fluctuating_within(const Rows& series, const Lengths& lengths) {
  constexpr double rounding = 1e-20;  // squared
  const Row total = (series.rowwise() - series.colwise().mean()).square().colwise().sum();
  Row within = Row::Zero(series.cols());
  for (Eigen::Index run = 0; run < lengths.count(); ++run) {
    const auto own = series.middleRows(lengths.begin(run), lengths.of(run));
    within += (own.rowwise() - own.colwise().mean()).square().colwise().sum();
  }
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < series.cols(); ++i)
    if (within[i] > rounding * total[i]) chosen.push_back(i);
  return chosen;
}

Rows of_columns(const Rows& series, const std::vector<Eigen::Index>& chosen) {
  return series(Eigen::seqN(Eigen::Index{0}, series.rows()), chosen);
}

// 2 tau s^2 of each series; nan where it is unknown.
Row variances(const Rows& series, const RunMeans& means, const Lengths& lengths, const Eigen::ArrayXd& time) {
  Row squares = Row::Zero(series.cols());
  for (Eigen::Index run = 0; run < lengths.count(); ++run)
    squares += (series.middleRows(lengths.begin(run), lengths.of(run)).rowwise() - means.mean.row(run))
                   .square()
                   .colwise()
                   .sum();
  const Row left =
      static_cast<double>(series.rows()) - static_cast<double>(lengths.count()) * time.transpose();
  return (left > 0).select(squares * time.transpose() / left, BetweenRuns::nan);
}

// Distribution of the mean over several series of squares that have `squares` degrees of freedom each.
struct Pooled {
  double above = 0, below = 0, bias = 1;
};

Pooled pooled(const CorrelationTime& within, double squares, double values_less_runs) {
  constexpr double fewest = 5;  // minimum for the variance of F to exist
  const double freedom = std::max(values_less_runs / within.squares, fewest);
  const double of_one = 2 * (squares + freedom - 2) / (squares * (freedom - 4));
  constexpr double most = 1e6;  // in place of infinity, if 2 tau is known to be 1
  return {2 * within.independent_series / of_one,
          std::min(most, 2 / std::max(within.uncertainty * within.uncertainty, 2 / most)),
          freedom / (freedom - 2)};
}

// Degrees of freedom of 2 tau s^2 of a single series, from those of its variance and of 2 tau.
double freedom_of_one(const CorrelationTime& within, const Pooled& pooled, double values_less_runs) {
  return 1 / (within.squares / values_less_runs + 1 / pooled.below);
}

double mean_of_known(const Row& values) {
  const auto known = values.isFinite();
  return known.any() ? known.select(values, 0).sum() / static_cast<double>(known.count()) : BetweenRuns::nan;
}

// Smallest chi^2 between two runs. Runs are compared in the order of the first series, so that equal runs are
// adjacent.
double nearest(const RunMeans& means, const Lengths& lengths, const Row& variance) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(lengths.count()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index one, Eigen::Index other) { return means.mean(one, 0) < means.mean(other, 0); });
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Eigen::Index one = order[i], other = order[i + 1];
    const double length =
        1 / (1 / static_cast<double>(lengths.of(one)) + 1 / static_cast<double>(lengths.of(other)));
    least = std::fmin(
        least, mean_of_known(length * (means.mean.row(one) - means.mean.row(other)).square() / variance));
  }
  return least;
}

}  // namespace

double RunMeans::freedom() const {
  const double square = squares();
  return std::pow(1 - square, 2) / (square - 2 * share.cube().sum() + square * square);
}

Eigen::ArrayXd RunMeans::variance_of_mean() const {
  const Row all = (mean.colwise() * share).colwise().sum();
  const Row spread = ((mean.rowwise() - all).square().colwise() * share).colwise().sum();
  return (squares() / (1 - squares()) * spread).transpose();
}

RunMeans run_means(const Rows& series, const std::vector<std::int64_t>& runs) {
  const Lengths lengths(runs);
  RunMeans means{Rows(lengths.count(), series.cols()), Eigen::ArrayXd(lengths.count())};
  for (Eigen::Index run = 0; run < lengths.count(); ++run) {
    means.mean.row(run) = series.middleRows(lengths.begin(run), lengths.of(run)).colwise().mean();
    means.share[run] = static_cast<double>(lengths.of(run)) / static_cast<double>(series.rows());
  }
  return means;
}

BetweenRuns between_runs(const Rows& all_series, const std::vector<std::int64_t>& runs) {
  const Lengths lengths(runs);
  BetweenRuns between;
  const auto count = static_cast<double>(lengths.count()), values = static_cast<double>(all_series.rows());
  constexpr double fewest_left = 4;
  if (count < 2 || values - count < fewest_left) return between;
  const std::vector<Eigen::Index> chosen = fluctuating_within(all_series, lengths);
  const Rows series = of_columns(all_series, chosen);
  if (series.cols() == 0) {
    between.chi_square = std::numeric_limits<double>::infinity();
    between.chance = 0;
    return between;
  }
  between.within = correlation_time(series, runs, About::own_means);
  if (std::isnan(between.within.time)) return between;
  const RunMeans means = run_means(series, runs);
  const Row variance = variances(series, means, lengths, between.within.of_series);
  const Row all = series.colwise().mean();
  const Row spread = ((means.mean.rowwise() - all).square().colwise() * means.share).colwise().sum();
  const Pooled of_all = pooled(between.within, count - 1, values - count);
  between.chi_square = mean_of_known(values * spread / variance) / (count - 1) / of_all.bias;
  between.chance = f_tail(between.chi_square, of_all.above, of_all.below);
  // Series that change from run to run only are no sample of their frames.
  between.chance_of_series = Eigen::ArrayXd::Zero(all_series.cols());
  const double freedom = freedom_of_one(between.within, of_all, values - count);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto one = static_cast<Eigen::Index>(i);
    const double ratio = values * spread[one] / variance[one] / (count - 1);
    between.chance_of_series[chosen[i]] = std::isfinite(ratio) ? f_tail(ratio, count - 1, freedom) : 1;
  }
  const Pooled of_two = pooled(between.within, 1, values - count);
  between.chance_of_near = std::min(
      1.0, 0.5 * count * (count - 1) *
               (1 - f_tail(nearest(means, lengths, variance) / of_two.bias, of_two.above, of_two.below)));
  return between;
}

}  // namespace mikromakro
