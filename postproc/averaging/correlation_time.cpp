#include "averaging/correlation_time.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "averaging/lagged_products.h"

namespace mikromakro {
namespace {

constexpr double window_over_time = 1.5;
constexpr double significant = 2;  // standard errors

// What products up to a lag tell.
struct Window {
  Eigen::ArrayXd rho;
  double time = 1;
  double squares = 1;
  double low = 0;  // by how much the time is too small, relative

  Eigen::Index lags() const { return rho.size() - 1; }
};

// A row for each lag, a column for each series.
Eigen::ArrayXXd covariances(const Eigen::ArrayXXd& products, const Eigen::ArrayXd& share) {
  const Eigen::Array<double, 1, Eigen::Dynamic> variance_of_mean =
      (share.matrix().transpose() * products.matrix()).array() / (1 - share.sum());
  return products.rowwise() + variance_of_mean;
}

// H_k/n^2.
Eigen::ArrayXd shares(const LaggedProducts& products, Eigen::Index lags) {
  Eigen::ArrayXd share(lags + 1);
  for (Eigen::Index lag = 0; lag <= lags; ++lag) share[lag] = (lag == 0 ? 1 : 2) * products.pairs(lag);
  return share / (products.count() * products.count());
}

Window window(LaggedProducts& products, Eigen::Index lags) {
  const double count = products.count();
  Eigen::ArrayXd mean(lags + 1);
  for (Eigen::Index lag = 0; lag <= lags; ++lag) mean[lag] = products.mean(lag);
  const Eigen::ArrayXd share = shares(products, lags);
  Window result;
  const Eigen::ArrayXXd covariance = covariances(mean, share);
  result.rho = covariance.col(0) / covariance(0, 0);
  const double time = count * (share * result.rho).sum();
  result.squares = 2 * result.rho.square().sum() - 1;
  result.low = std::clamp(2 * (time - result.squares) / count, -0.5, 0.5);
  result.time = time / (1 - result.low);
  return result;
}

// Whether the lags behind those of `now` still tell something.
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
  if (products.all_lags()) return window(products, products.longest());
  return {};
}

// Relative variance of 2 tau of one series.
double variance_of_one(const Window& window, double count) {
  const Eigen::Index lags = window.lags();
  const auto rho = [&](Eigen::Index lag) { return std::abs(lag) > lags ? 0 : window.rho[std::abs(lag)]; };
  const double time = 2 * window.rho.sum() - 1;
  double sum = 0;
  for (Eigen::Index j = -2 * lags; j <= 2 * lags; ++j) {
    double h = -time * rho(j);
    for (Eigen::Index k = -lags; k <= lags; ++k) h += rho(j - k);
    sum += h * h;
  }
  return 2 * sum / (count * std::pow(std::max(time, 1.0), 2));
}

Eigen::ArrayXd own_times(LaggedProducts& products, const Window& window) {
  Eigen::ArrayXXd own(window.lags() + 1, products.series());
  for (Eigen::Index lag = 0; lag <= window.lags(); ++lag) own.row(lag) = products.of_series(lag).transpose();
  const Eigen::ArrayXd share = shares(products, window.lags());
  const Eigen::ArrayXXd covariance = covariances(own, share);
  const Eigen::ArrayXd sum = (share.matrix().transpose() * covariance.matrix()).transpose().array();
  return products.count() * sum / (1 - window.low) / covariance.row(0).transpose();
}

// Variance between series beyond that of their own values; both relative.
double variance_between(const Eigen::ArrayXd& relative, double of_one, double independent) {
  constexpr double fewest = 0.5;
  const double variance = (relative - relative.mean()).square().mean() * independent;
  return std::max(0.0, (variance / std::max(independent - 1, fewest) - of_one) / (1 + of_one));
}

}  // namespace

CorrelationTime correlation_time(const Eigen::ArrayXXd& series, const std::vector<std::int64_t>& runs) {
  LaggedProducts products(series, runs);
  CorrelationTime result;
  const std::optional<Window> window = closed_window(products);
  if (!window) return result;
  result.most = products.longest_run();
  result.time = std::max(window->time, 1.0);
  result.squares = window->squares;
  result.independent_series = products.independent_series(result.squares);
  const double of_one = variance_of_one(*window, products.count());
  const double of_all = of_one / result.independent_series;
  const Eigen::ArrayXd relative = own_times(products, *window) / result.time;
  const double between = variance_between(relative, of_one, result.independent_series);
  const double kept = between > 0 ? between / (between + of_one) : 0;
  result.uncertainty = std::sqrt(of_all);
  result.scatter = std::sqrt(between);
  result.of_series = (result.time * (1 + kept * (relative - 1))).max(1);
  result.uncertainty_of_series = std::sqrt(kept * of_one + (1 - kept) * (1 - kept) * of_all);
  return result;
}

}  // namespace mikromakro
