// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/error_trials.h"

#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

TimeAverage average_of(const Trials& trials, std::mt19937_64& random) {
  constexpr std::size_t numbers = 60;  // that a table sums in each volume
  const auto volumes = static_cast<std::size_t>(trials.truth.rows());
  TimeAverage average(trials.blocks > 0 ? trials.blocks : suitable_blocks(numbers * volumes));
  for (int run = 0; trials.run && run < trials.runs; ++run)
    for (const Rows& frame : trials.run(random)) average.add(frame, run);
  for (std::size_t run = 0; run < trials.lengths.size(); ++run)
    for (const Rows& frame : trials.run_of(trials.lengths[run], random))
      average.add(frame, static_cast<std::int64_t>(run));
  return average;
}

// Of pairs of the same run.
double autocovariance(const Eigen::ArrayXd& deviation, const std::vector<std::int64_t>& runs,
                      Eigen::Index lag) {
  const Eigen::Index count = deviation.size();
  double sum = 0;
  double pairs = 0;
  for (Eigen::Index i = 0; i + lag < count; ++i) {
    if (runs[static_cast<std::size_t>(i)] != runs[static_cast<std::size_t>(i + lag)]) continue;
    sum += deviation[i] * deviation[i + lag];
    ++pairs;
  }
  return sum / pairs * static_cast<double>(count - lag) / static_cast<double>(count);
}

double error_of_one(const Eigen::ArrayXd& series, const std::vector<std::int64_t>& runs) {
  const Eigen::ArrayXd deviation = series - series.mean();
  const double variance = autocovariance(deviation, runs, 0);
  const auto count = static_cast<double>(series.size());
  double time = 1;
  for (Eigen::Index lag = 1; lag < series.size() / 2; ++lag) {
    const double covariance = autocovariance(deviation, runs, lag);
    if (std::isnan(covariance)) break;
    time += 2 * (covariance / variance + 1 / count);
    if (static_cast<double>(lag) >= 1.5 * time) break;
  }
  time = std::max(time, 1.0);
  return count < 16 * time ? std::numeric_limits<double>::quiet_NaN()
                           : std::sqrt(time * variance / (count - 1));
}

}  // namespace

std::vector<Rows> CorrelatedNoise::operator()(int frames, std::mt19937_64& random) const {
  std::normal_distribution<double> normal;
  const auto noise = [&] { return Rows(Rows::NullaryExpr(rows_, columns_, [&] { return normal(random); })); };
  std::vector<Rows> series{noise()};
  while (static_cast<int>(series.size()) < frames)
    series.emplace_back(rho_ * series.back() + std::sqrt(1 - rho_ * rho_) * noise());
  return series;
}

Rows errors_of_field(const TimeAverage& average, const Solver& solve) {
  return block_errors(average, solve, {{"field", solve(average.mean()).cols()}}).error;
}

Rows errors_one_by_one(const TimeAverage& average, const Solver& solve) {
  const auto count = static_cast<double>(average.blocks().size());
  Rows total = average.blocks().front();
  for (std::size_t i = 1; i < average.blocks().size(); ++i) total += average.blocks()[i];
  const Rows whole = solve(total / count);
  std::vector<Rows> values;
  for (const Rows& block : average.blocks())
    values.emplace_back(count * whole - (count - 1) * solve((total - block) / (count - 1)));
  Rows errors = whole;
  Eigen::ArrayXd series(values.size());
  for (Eigen::Index i = 0; i < whole.size(); ++i) {
    for (std::size_t block = 0; block < values.size(); ++block)
      series[static_cast<Eigen::Index>(block)] = values[block].data()[i];
    errors.data()[i] = error_of_one(series, average.runs());
  }
  return errors;
}

Coverage coverage(const Trials& trials, const MakeErrors& errors) {
  std::mt19937_64 random(17);
  const Solver solve = trials.solve ? trials.solve : [](const Rows& sums) { return sums; };
  double all = 0, with_errors = 0, given = 0, one_sigma = 0, two_sided = 0;
  for (int i = 0; i < trials.count; ++i) {
    const TimeAverage average = average_of(trials, random);
    const Rows distance = (solve(average.mean()) - trials.truth).abs();
    const Rows error = errors(average, solve);
    all += static_cast<double>(error.size());
    given += static_cast<double>(error.isFinite().count());
    if (error.isFinite().any()) ++with_errors;
    one_sigma += static_cast<double>((distance < error).count());
    two_sided += static_cast<double>((distance < 1.959964 * error).count());
  }
  return {given / all, with_errors / trials.count, one_sigma / given, two_sided / given};
}

}  // namespace mikromakro
