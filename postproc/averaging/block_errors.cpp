#include "averaging/block_errors.h"

#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Of each block.
std::vector<Rows> pseudo_values(const std::vector<Rows>& blocks, const Solver& solve) {
  const auto count = static_cast<double>(blocks.size());
  Rows total = blocks.front();
  for (std::size_t i = 1; i < blocks.size(); ++i) total += blocks[i];
  const Rows whole = solve(total / count);
  std::vector<Rows> values;
  values.reserve(blocks.size());
  for (const Rows& block : blocks)
    values.push_back(count * whole - (count - 1) * solve((total - block) / (count - 1)));
  return values;
}

// Where a series stands among the results.
struct Place {
  Eigen::Index row, column;
};

struct FieldSeries {
  std::vector<Place> places;
  Eigen::ArrayXXd values;  // a row for each block, a column for each place
};

Eigen::ArrayXd series_at(const std::vector<Rows>& values, Place place) {
  Eigen::ArrayXd series(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    series[static_cast<Eigen::Index>(i)] = values[i](place.row, place.column);
  return series;
}

double variance(const Eigen::ArrayXd& series) {
  return (series - series.mean()).square().mean();
}

// Beyond rounding; not true for nan either.
bool fluctuates(const Eigen::ArrayXd& series) {
  constexpr double rounding = 1e-13;
  return std::sqrt(variance(series)) > rounding * std::abs(series.mean());
}

FieldSeries fluctuating_series(const std::vector<Rows>& values, Eigen::Index begin, Eigen::Index columns) {
  FieldSeries found;
  for (Eigen::Index row = 0; row < values.front().rows(); ++row) {
    for (Eigen::Index column = begin; column < begin + columns; ++column) {
      if (fluctuates(series_at(values, {row, column}))) found.places.push_back({row, column});
    }
  }
  const auto count = static_cast<Eigen::Index>(found.places.size());
  found.values.resize(static_cast<Eigen::Index>(values.size()), count);
  for (Eigen::Index i = 0; i < count; ++i)
    found.values.col(i) = series_at(values, found.places[static_cast<std::size_t>(i)]);
  return found;
}

void fill(const FieldSeries& series, const FieldErrors& field, std::int64_t block_length,
          BlockErrors& errors) {
  const auto count = static_cast<double>(series.values.rows());
  for (std::size_t i = 0; i < series.places.size(); ++i) {
    const auto [row, column] = series.places[i];
    const auto index = static_cast<Eigen::Index>(i);
    const double time = field.correlation.of_series[index];
    // A series of its own time may be all one correlation.
    if (!(time < count)) continue;
    errors.error(row, column) =
        field.decision.widening * std::sqrt(variance(series.values.col(index)) * time / (count - time));
    errors.correlation_time(row, column) = time * static_cast<double>(block_length);
  }
}

}  // namespace

BlockErrors block_errors(const TimeAverage& average, const Solver& solve,
                         const std::vector<ColumnsOfField>& fields) {
  const std::vector<Rows>& blocks = average.blocks();
  BlockErrors errors;
  errors.frames = average.frames();
  const Rows values = solve(average.mean());
  errors.error = Rows::Constant(values.rows(), values.cols(), nan);
  errors.correlation_time = errors.error;
  constexpr std::size_t fewest_blocks = 8;
  const auto jackknife = blocks.size() < fewest_blocks ? std::vector<Rows>{} : pseudo_values(blocks, solve);
  Eigen::Index begin = 0;
  for (const ColumnsOfField& field : fields) {
    errors.fields.push_back({field, 0, {}, {}});
    if (jackknife.empty()) continue;
    const FieldSeries series = fluctuating_series(jackknife, begin, field.count);
    begin += field.count;
    if (series.places.empty()) continue;
    FieldErrors& made = errors.fields.back();
    made.series = series.values.cols();
    made.correlation = correlation_time(series.values, average.runs());
    made.decision = decide(made.correlation, static_cast<double>(blocks.size()));
    if (made.decision.given) fill(series, made, average.block_length(), errors);
    made.correlation.time *= static_cast<double>(average.block_length());
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

Rows BlockErrors::times_of_fields() const {
  Rows times = Rows::Constant(error.rows(), static_cast<Eigen::Index>(fields.size()), nan);
  for (Eigen::Index row = 0; row < error.rows(); ++row) {
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      double& slowest = times(row, static_cast<Eigen::Index>(i));
      for (const Eigen::Index end = column + fields[i].field.count; column < end; ++column)
        slowest = std::fmax(slowest, correlation_time(row, column));
    }
  }
  return times;
}

void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table) {
  for (const Column& column : columns)
    table.columns.push_back(
        {column.name + "_err", column.unit, "jackknife", "standard error of " + column.name});
  table.columns.push_back({"effective_samples", "1", "-",
                           "independent frames, of the quantity of this row that changes slowest"});
  for (const FieldErrors& made : errors.fields)
    table.columns.push_back({made.field.name + "_two_tau", "frames", "-",
                             "correlation time 2 tau, of the slowest column of " + made.field.name});
  const Rows times = errors.times_of_fields();
  Rows rows(table.rows.rows(), table.rows.cols() + errors.error.cols() + 1 + times.cols());
  rows << table.rows, errors.error, errors.effective_samples(), times;
  table.rows = std::move(rows);
}

}  // namespace mikromakro
