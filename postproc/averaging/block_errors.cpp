#include "averaging/block_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double fewest_independent = 16;
constexpr double window_over_time = 1.5;

struct Jackknife {
  std::vector<Rows> pseudo_values;  // of each block
  Rows error;
};

Jackknife jackknife(const std::vector<Rows>& blocks, const Solver& solve) {
  const auto count = static_cast<double>(blocks.size());
  Rows total = blocks.front();
  for (std::size_t i = 1; i < blocks.size(); ++i) total += blocks[i];
  const Rows whole = solve(total / count);
  Jackknife result;
  Rows mean = Rows::Zero(whole.rows(), whole.cols());
  for (const Rows& block : blocks) {
    const Rows without = solve((total - block) / (count - 1));
    result.pseudo_values.push_back(count * whole - (count - 1) * without);
    mean += result.pseudo_values.back() / count;
  }
  Rows squares = Rows::Zero(whole.rows(), whole.cols());
  for (const Rows& value : result.pseudo_values) squares += (value - mean).square();
  result.error = (squares / (count * (count - 1))).sqrt();
  return result;
}

// Of blocks of the same run: runs do not depend on each other. Pairs of different runs are left out, and the
// others count for them.
double autocovariance(const Eigen::ArrayXd& deviation, const std::vector<std::int64_t>& runs,
                      Eigen::Index lag) {
  const Eigen::Index count = deviation.size();
  double sum = 0;
  Eigen::Index pairs = 0;
  for (Eigen::Index i = 0; i + lag < count; ++i) {
    if (runs[static_cast<std::size_t>(i)] != runs[static_cast<std::size_t>(i + lag)]) continue;
    sum += deviation[i] * deviation[i + lag];
    ++pairs;
  }
  if (pairs == 0) return nan;
  return sum * (static_cast<double>(count - lag) / static_cast<double>(pairs)) / static_cast<double>(count);
}

// 2 tau in blocks; nan where the series does not fluctuate beyond rounding.
double correlation_time(const Eigen::ArrayXd& series, const std::vector<std::int64_t>& runs) {
  const double mean = series.mean();
  const Eigen::ArrayXd deviation = series - mean;
  const double variance = autocovariance(deviation, runs, 0);
  constexpr double rounding = 1e-13;
  if (!(std::sqrt(variance) > rounding * std::abs(mean))) return nan;
  const auto count = static_cast<double>(series.size());
  double time = 1;
  for (Eigen::Index lag = 1; lag < series.size() / 2; ++lag) {
    const double covariance = autocovariance(deviation, runs, lag);
    if (std::isnan(covariance)) break;  // longer than every run
    // The mean of the series is taken off, which lowers each rho by 1/count.
    time += 2 * (covariance / variance + 1 / count);
    if (static_cast<double>(lag) >= window_over_time * time) break;
  }
  return std::max(time, 1.0);
}

Eigen::ArrayXd series_at(const std::vector<Rows>& values, Eigen::Index row, Eigen::Index column) {
  Eigen::ArrayXd series(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    series[static_cast<Eigen::Index>(i)] = values[i](row, column);
  return series;
}

}  // namespace

BlockErrors block_errors(const TimeAverage& average, const Solver& solve) {
  const Rows values = solve(average.mean());
  BlockErrors errors;
  errors.frames = average.frames();
  errors.error = Rows::Constant(values.rows(), values.cols(), nan);
  errors.correlation_time = errors.error;
  const auto blocks = static_cast<double>(average.blocks().size());
  if (blocks < fewest_independent) return errors;
  const Jackknife jack = jackknife(average.blocks(), solve);
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      const double time = correlation_time(series_at(jack.pseudo_values, row, column), average.runs());
      errors.correlation_time(row, column) = time * static_cast<double>(average.block_length());
      // Not true for nan either.
      if (blocks >= fewest_independent * time)
        errors.error(row, column) = std::sqrt(time) * jack.error(row, column);
    }
  }
  return errors;
}

Eigen::ArrayXd BlockErrors::effective_samples() const {
  Eigen::ArrayXd samples = Eigen::ArrayXd::Constant(error.rows(), nan);
  for (Eigen::Index row = 0; row < error.rows(); ++row) {
    for (Eigen::Index column = 0; column < error.cols(); ++column)
      samples[row] = std::fmin(samples[row], static_cast<double>(frames) / correlation_time(row, column));
  }
  return samples;
}

void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table) {
  for (const Column& column : columns)
    table.columns.push_back(
        {column.name + "_err", column.unit, "jackknife", "standard error of " + column.name});
  table.columns.push_back({"effective_samples", "1", "-",
                           "independent frames, of the quantity of this row that changes slowest"});
  Rows rows(table.rows.rows(), table.rows.cols() + errors.error.cols() + 1);
  rows << table.rows, errors.error, errors.effective_samples();
  table.rows = std::move(rows);
}

}  // namespace mikromakro
