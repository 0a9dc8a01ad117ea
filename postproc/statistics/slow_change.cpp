// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/slow_change.h"

#include <cmath>
#include <numbers>

#include "statistics/f_distribution.h"

namespace mikromakro {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

constexpr int waves = 5;
constexpr double shortest_run = 10;  // to be examined, in units of 2 tau

// Squared amplitude of a wave in one run.
Row square_of_wave(const Eigen::Ref<const Rows>& run, int k) {
  const auto count = static_cast<double>(run.rows());
  Row wave = Row::Zero(run.cols());
  for (Eigen::Index i = 0; i < run.rows(); ++i)
    wave += std::cos(std::numbers::pi * k * (static_cast<double>(i) + 0.5) / count) * run.row(i);
  return 2 / count * wave.square();
}

// As many series as are used to determine 2 tau, evenly spread.
Rows some_of(const Rows& series) {
  constexpr Eigen::Index most = 1000;
  if (series.cols() <= most) return series;
  Rows some(series.rows(), most);
  for (Eigen::Index i = 0; i < most; ++i) some.col(i) = series.col(i * series.cols() / most);
  return some;
}

}  // namespace

SlowChange slow_change(const Rows& all_series, const std::vector<std::int64_t>& runs,
                       const CorrelationTime& time) {
  const Rows series = some_of(all_series);
  Row slowest = Row::Zero(series.cols()), next = slowest;
  double independent = 0;
  for (std::size_t begin = 0, end = 0; begin < runs.size(); begin = end) {
    while (end < runs.size() && runs[end] == runs[begin]) ++end;
    if (static_cast<double>(end - begin) < shortest_run * time.time) continue;
    const auto run =
        series.middleRows(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
    slowest += square_of_wave(run, 1);
    for (int k = 2; k <= waves; ++k) next += square_of_wave(run, k) / (waves - 1);
    independent += time.independent_series;
  }
  if (independent == 0) return {};
  const Row variance = (series.rowwise() - series.colwise().mean()).square().colwise().mean();
  const double ratio = (slowest / variance).sum() / (next / variance).sum();
  return {ratio, f_tail(ratio, independent, (waves - 1) * independent)};
}

}  // namespace mikromakro
