// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/block_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mikromakro {
namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Flat indices of the series that fluctuate, volume by volume.
std::vector<Eigen::Index> places_of(const PseudoValues& values, Eigen::Index begin, Eigen::Index columns) {
  std::vector<Eigen::Index> places;
  for (Eigen::Index row = 0; row < values.fluctuate.rows(); ++row) {
    for (Eigen::Index column = begin; column < begin + columns; ++column) {
      if (values.fluctuate(row, column)) places.push_back(row * values.fluctuate.cols() + column);
    }
  }
  return places;
}

// One row per block, one column per index.
Rows series_at(const std::vector<Eigen::Index>& places, const std::vector<Rows>& blocks) {
  Rows series(static_cast<Eigen::Index>(blocks.size()), static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i)
    series.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Row>(blocks[i].data(), blocks[i].size())(places);
  return series;
}

void fill(const std::vector<Eigen::Index>& places, const PseudoValues& values, const FieldErrors& field,
          BlockErrors& errors) {
  const auto count = static_cast<double>(values.deviations.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double time = field.correlation.of_series[static_cast<Eigen::Index>(i)];
    // A single series may be correlated over its whole length.
    if (!(time < count)) continue;
    const double variance = values.variance.data()[places[i]];
    errors.error.data()[places[i]] = field.decision.widening * std::sqrt(variance * time / (count - time));
    errors.correlation_time.data()[places[i]] = time;
  }
}

void fill_by_runs(const std::vector<Eigen::Index>& places, const RunMeans& means, const FieldErrors& field,
                  BlockErrors& errors, double blocks) {
  const Eigen::ArrayXd error = field.decision.widening * means.variance_of_mean().sqrt();
  for (std::size_t i = 0; i < places.size(); ++i) {
    errors.error.data()[places[i]] = error[static_cast<Eigen::Index>(i)];
    errors.correlation_time.data()[places[i]] = blocks / field.decision.samples;
  }
}

// Independent runs of about the same length: their spread is the error whether it shows that they differ or
// not.
bool are_enough(const RunMeans& means) {
  constexpr double runs = 7;  // 1/sum w^2
  return 1 / means.squares() >= runs;
}

// Single series that differ from run to run, among others that do not: of their spread, or none.
void replace_differing(const std::vector<Eigen::Index>& places, const RunMeans& means,
                       const FieldErrors& field, BlockErrors& errors) {
  const ErrorDecision by_runs = decide_by_runs(means.freedom());
  const Eigen::ArrayXd error = by_runs.widening * means.variance_of_mean().sqrt();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto series = static_cast<Eigen::Index>(i);
    if (field.between.differs(series)) errors.error.data()[places[i]] = by_runs.given ? error[series] : nan;
  }
}

FieldErrors errors_of(const ColumnsOfField& field, Eigen::Index begin, const PseudoValues& values,
                      const std::vector<std::int64_t>& runs, BlockErrors& errors) {
  FieldErrors made{field};
  const std::vector<Eigen::Index> places = places_of(values, begin, field.count);
  if (places.empty()) return made;
  made.series = static_cast<Eigen::Index>(places.size());
  const Rows series = series_at(places, values.deviations);
  const auto count = static_cast<double>(values.deviations.size());
  made.between = between_runs(series, runs);
  made.correlation = made.between.differ() ? made.between.within : correlation_time(series, runs);
  made.decision = decide(made.correlation, count);
  const RunMeans means = run_means(series, runs);
  const bool spread = made.between.differ() || (std::isfinite(made.between.chi_square) && are_enough(means));
  if (!spread && !made.decision.given) return made;
  if (made.decision.given) made.slow = slow_change(series, runs, made.correlation);
  if (spread || made.slow.shows()) {
    made.decision = decide_by_runs(means.freedom());
    if (made.decision.given) fill_by_runs(places, means, made, errors, count);
  } else {
    fill(places, values, made, errors);
    replace_differing(places, means, made, errors);
  }
  return made;
}

// What is left of the errors of columns that are not linear in the sums.
void correct(Eigen::Index begin, const Rows& values, const PseudoValues& jackknife, FieldErrors& made,
             BlockErrors& errors) {
  const Eigen::Index count = made.field.count;
  auto error = errors.error.middleCols(begin, count);
  auto time = errors.correlation_time.middleCols(begin, count);
  made.nonlinear = correct_nonlinear(made.field, values.middleCols(begin, count),
                                     jackknife.curvature.middleCols(begin, count), error);
  time = error.isNaN().select(nan, time);
  if (made.nonlinear.curved.empty() || error.isFinite().any()) return;
  made.decision.given = false;
  for (const CurvedColumn& curved : made.nonlinear.curved)
    made.decision.needed = std::max(made.decision.needed, curved.frames_needed * made.decision.samples);
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
  const bool enough = errors.enough_blocks = blocks.size() >= fewest_blocks;
  const PseudoValues jackknife = enough ? pseudo_values(blocks, solve, fields) : PseudoValues{};
  const auto length = static_cast<double>(average.block_length());
  Eigen::Index begin = 0;
  for (const ColumnsOfField& field : fields) {
    errors.fields.push_back(enough ? errors_of(field, begin, jackknife, average.runs(), errors)
                                   : FieldErrors{field});
    if (enough) correct(begin, values, jackknife, errors.fields.back(), errors);
    errors.fields.back().correlation.time *= length;
    begin += field.count;
  }
  errors.correlation_time *= length;
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

bool BlockErrors::all() const {
  return std::all_of(fields.begin(), fields.end(),
                     [](const FieldErrors& made) { return made.series == 0 || made.decision.given; });
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

std::vector<Column> error_columns(const std::vector<Column>& columns,
                                  const std::vector<ColumnsOfField>& fields) {
  std::vector<Column> added;
  added.reserve(columns.size() + 1 + fields.size());
  for (const Column& column : columns)
    added.push_back({column.name + "_err", column.unit, "jackknife", "standard error of " + column.name});
  added.push_back({"effective_samples", "1", "-",
                   "independent frames, of the quantity of this row that changes most slowly"});
  for (const ColumnsOfField& field : fields)
    added.push_back({field.name + "_two_tau", "frames", "-",
                     "correlation time 2 tau, of the slowest column of " + field.name});
  return added;
}

void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table) {
  std::vector<ColumnsOfField> fields;
  fields.reserve(errors.fields.size());
  for (const FieldErrors& made : errors.fields) fields.push_back(made.field);
  for (Column& column : error_columns(columns, fields)) table.columns.push_back(std::move(column));
  const Rows times = errors.times_of_fields();
  Rows rows(table.rows.rows(), table.rows.cols() + errors.error.cols() + 1 + times.cols());
  rows << table.rows, errors.error, errors.effective_samples(), times;
  table.rows = std::move(rows);
}

}  // namespace mikromakro
