// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/steady_state.h"

#include <cmath>
#include <Eigen/Core>
#include <stdexcept>

#include "statistics/correlation_time.h"

namespace mikromakro {
namespace {

Eigen::ArrayXd batch_means(const std::vector<double>& series) {
  const Eigen::Map<const Eigen::ArrayXXd> values(series.data(), SteadyState::batch,
                                                 std::ssize(series) / SteadyState::batch);
  return values.colwise().mean().transpose();
}

double mser(const Eigen::ArrayXd& rest) {
  const auto count = static_cast<double>(rest.size());
  return (rest - rest.mean()).square().sum() / (count * count);
}

std::int64_t best_cut(const Eigen::ArrayXd& batches) {
  Eigen::Index cut = 0;
  double least = mser(batches);
  for (Eigen::Index d = 1; 2 * d <= batches.size(); ++d) {
    const double here = mser(batches.tail(batches.size() - d));
    if (here >= least) continue;
    least = here;
    cut = d;
  }
  return cut * SteadyState::batch;
}

void fit_line(const std::vector<double>& values, SteadyState& state) {
  const Eigen::Map<const Eigen::ArrayXd> rest(values.data(), std::ssize(values));
  const auto count = static_cast<double>(rest.size());
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(rest.size(), 0.5 / count, 1 - 0.5 / count) - 0.5;
  state.change = (time * rest).sum() / time.square().sum();
  const Eigen::ArrayXd about = rest - rest.mean() - state.change * time;
  const double variance = about.square().sum() / (count - 2);
  constexpr double rounding = 1e-13;
  if (std::sqrt(variance) <= rounding * rest.abs().maxCoeff()) {
    state.error = rounding * rest.abs().maxCoeff();
    return;
  }
  state.two_tau =
      correlation_time(about, std::vector<std::int64_t>(static_cast<std::size_t>(rest.size()), 0)).time;
  state.error = std::sqrt(12 * state.two_tau * variance / count);
}

}  // namespace

bool SteadyState::steady() const {
  return std::abs(change) <= most * error;
}

SteadyState steady_state(const std::vector<double>& series) {
  if (std::ssize(series) < SteadyState::fewest) throw std::invalid_argument("too short a series");
  const std::int64_t latest = std::ssize(series) / SteadyState::batch / 2 * SteadyState::batch;
  SteadyState state;
  for (state.begin = best_cut(batch_means(series));; state.begin += SteadyState::batch) {
    fit_line({series.begin() + state.begin, series.end()}, state);
    if (state.steady() || state.begin >= latest) break;
  }
  return state;
}

}  // namespace mikromakro
