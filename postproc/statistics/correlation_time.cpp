// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/correlation_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "statistics/lagged_products.h"

namespace mikromakro {
namespace {

constexpr double window_over_time = 1.5;
constexpr double significant = 1.5;  // standard errors

// Results of summing the products up to a lag.
struct Window {
  Eigen::ArrayXd rho;
  double time = 1;
  double squares = 1;
  double low = 0;         // relative amount by which the time is too small
  double subtracted = 0;  // part of the sum that the subtracted means took away
  double missing = 1;     // of the variance of the mean, in the products at lag 0

  Eigen::Index lags() const { return rho.size() - 1; }
};

// H_k/n^2.
Eigen::ArrayXd shares(const LaggedProducts& products, Eigen::Index lags) {
  Eigen::ArrayXd share(lags + 1);
  for (Eigen::Index lag = 0; lag <= lags; ++lag) share[lag] = (lag == 0 ? 1 : 2) * products.pairs(lag);
  return share / (products.count() * products.count());
}

Window window(LaggedProducts& products, Eigen::Index lags) {
  const double count = products.count();
  Eigen::ArrayXd mean(lags + 1), missing(lags + 1);
  for (Eigen::Index lag = 0; lag <= lags; ++lag) {
    mean[lag] = products.mean(lag);
    missing[lag] = products.missing(lag);
  }
  const Eigen::ArrayXd share = shares(products, lags);
  Window result;
  result.subtracted = (share * missing).sum();
  result.missing = missing[0];
  const double variance_of_mean = (share * mean).sum() / (1 - result.subtracted);
  result.rho = (mean + missing * variance_of_mean) / (1 + missing[0] * variance_of_mean);
  const double time = count * (share * result.rho).sum();
  result.squares = 2 * result.rho.square().sum() - 1;
  result.low = std::clamp(2 * (time - result.squares) / count, -0.5, 0.5);
  result.time = time / (1 - result.low);
  return result;
}

// Whether the lags after those of `now` still contribute significantly.
bool goes_on(const Window& now, LaggedProducts& products) {
  const Eigen::Index ahead = std::min(2 * now.lags() + 2, products.longest());
  if (ahead == now.lags()) return false;
  const double known = products.count() * products.independent_series(now.squares);
  const double error = 2 * std::sqrt(static_cast<double>(ahead - now.lags()) * now.squares / known);
  return window(products, ahead).time - now.time > significant * error;
}

std::optional<Window> closed_window(LaggedProducts& products) {
  for (Eigen::Index lags = 1; lags <= products.longest(); ++lags) {
    const Window now = window(products, lags);
    if (static_cast<double>(lags) >= window_over_time * now.time && !goes_on(now, products)) return now;
  }
  if (!products.all_lags()) return {};
  const Window all = window(products, products.longest());
  // If runs consist of two values, subtracting their own means leaves nothing.
  constexpr double most_subtracted = 0.9;
  if (all.subtracted > most_subtracted) return {};
  return all;
}

// Relative variance of 2 tau of one series; h_j is even in j.
double variance_of_one(const Window& window, double count) {
  const Eigen::Index lags = window.lags();
  const auto rho = [&](Eigen::Index lag) { return std::abs(lag) > lags ? 0 : window.rho[std::abs(lag)]; };
  const double time = 2 * window.rho.sum() - 1;
  double near = time;  // the sum of rho_(j-k)
  double sum = 0;
  for (Eigen::Index j = 0; j <= 2 * lags; ++j) {
    const double h = near - time * rho(j);
    sum += (j == 0 ? 1 : 2) * h * h;
    near -= rho(j - lags);
  }
  return 2 * sum / (count * std::pow(std::max(time, 1.0), 2));
}

// n V/(1 + V), with V the variance of the mean of a series (missing once, at lag 0).
Eigen::ArrayXd own_times(const LaggedProducts& products, const Window& window,
                         const Eigen::ArrayXd& in_window) {
  const Eigen::ArrayXd variance_of_mean = in_window / (1 - window.subtracted);
  return products.count() / (1 - window.low) * variance_of_mean / (1 + window.missing * variance_of_mean);
}

// Relative variation of 2 tau between series.
struct Scatter {
  double variance = 0;  // in excess of the statistical variance of single values
  bool by_chance = true;
};

Scatter scatter_of(const Eigen::ArrayXd& relative, double of_one, double independent) {
  constexpr double fewest = 0.5, beyond_chance = 3;  // standard errors
  const double others = std::max(independent - 1, fewest);
  const double variance = (relative - relative.mean()).square().mean() * independent / others;
  const double excess = std::max(0.0, variance - of_one);
  return {excess / (1 + of_one), excess <= beyond_chance * of_one * std::sqrt(2 / others)};
}

constexpr double significant_of_one = 4;  // standard errors

// By how much an equal number of lags after the window adds more in each series than in all, in standard
// errors.
Eigen::ArrayXd beyond_window(LaggedProducts& products, const Window& window,
                             const Eigen::ArrayXd& in_window) {
  const Eigen::Index lags = window.lags(), ahead = std::min(2 * lags + 2, products.longest());
  if (ahead == lags) return Eigen::ArrayXd::Zero(in_window.size());
  const double pairs = shares(products, ahead).sum() - shares(products, lags).sum();
  double of_all = 0;
  for (Eigen::Index lag = lags + 1; lag <= ahead; ++lag) of_all += products.mean(lag);
  const auto more = static_cast<double>(ahead - lags);
  const Eigen::ArrayXd of_one = more * (products.sums_of_series(ahead) - in_window) / pairs;
  return (of_one - of_all) / std::sqrt(more * window.squares * std::max(window.time, 1.0) / products.count());
}

// Subtracts only the amount that normal series have by chance.
double square_skewness(const LaggedProducts& products, double squares) {
  return std::max(0.0, products.square_skewness() - 6 * squares / products.count());
}

}  // namespace

CorrelationTime correlation_time(Rows series, const std::vector<std::int64_t>& runs, About about) {
  LaggedProducts products(std::move(series), runs, about);
  CorrelationTime result;
  const std::optional<Window> window = closed_window(products);
  if (!window) return result;
  result.most = products.longest_run();
  result.time = std::max(window->time, 1.0);
  result.squares = window->squares;
  result.square_skewness = square_skewness(products, result.squares);
  result.independent_series = products.independent_series(result.squares);
  double of_one = variance_of_one(*window, products.count());
  // Dividing by the part of the sum that the means of short runs leave magnifies its error.
  if (about == About::own_means) of_one /= std::pow(1 - window->subtracted, 2);
  const double of_all = of_one / result.independent_series;
  const Eigen::ArrayXd in_window = products.sums_of_series(window->lags());
  const Eigen::ArrayXd relative = own_times(products, *window, in_window) / result.time;
  const Scatter scatter = scatter_of(relative, of_one, result.independent_series);
  const double kept = scatter.variance > 0 ? scatter.variance / (scatter.variance + of_one) : 0;
  result.uncertainty = std::sqrt(of_all);
  result.scatter = std::sqrt(scatter.variance);
  if (!scatter.by_chance) result.unknown_scatter = (1 - kept) * result.scatter;
  result.of_series = (result.time * (1 + kept * (relative - 1))).max(1);
  // Slower than the window shows, or than the shrunken value.
  const auto slow = beyond_window(products, *window, in_window) > significant_of_one ||
                    relative - result.of_series / result.time > significant_of_one * std::sqrt(of_one);
  result.of_series = slow.select(std::numeric_limits<double>::quiet_NaN(), result.of_series).eval();
  result.uncertainty_of_series = std::sqrt(kept * of_one + (1 - kept) * (1 - kept) * of_all);
  return result;
}

}  // namespace mikromakro
