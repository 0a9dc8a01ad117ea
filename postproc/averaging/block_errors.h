// SPDX-License-Identifier: GPL-2.0-or-later
// Standard errors of solved quantities from block averages.
#pragma once

#include "averaging/nonlinear_errors.h"
#include "averaging/pseudo_values.h"
#include "averaging/time_average.h"
#include "statistics/between_runs.h"
#include "statistics/error_decision.h"
#include "statistics/slow_change.h"

namespace mikromakro {

/// How the errors of a field were obtained; times are in frames.
struct FieldErrors {
  ColumnsOfField field;
  Eigen::Index series = 0;  ///< number of series that fluctuate
  CorrelationTime correlation{};
  ErrorDecision decision{};
  SlowChange slow{};
  BetweenRuns between{};  ///< comparison of several runs
  NonlinearErrors nonlinear{};
};

/// One number per volume and column.
struct BlockErrors {
  Rows error;             ///< standard error; nan if it cannot be determined
  Rows correlation_time;  ///< 2 tau, in frames; nan if there is no error
  std::int64_t frames = 0;
  bool enough_blocks = false;  ///< at least eight
  std::vector<FieldErrors> fields;

  /// frames/(2 tau) of the slowest column of each volume, among those with errors; nan if there is none.
  Eigen::ArrayXd effective_samples() const;
  /// 2 tau of the slowest column of each field in each volume.
  Rows times_of_fields() const;
  /// Whether any error is known, and whether all fields have errors.
  bool any() const { return error.isFinite().any(); }
  bool all() const;
};

/// Delete-one-block jackknife of the output of `solve`: the pseudo-values of m blocks are m q - (m - 1) q_i,
/// with q_i computed from the mean of all blocks but i. For quantities linear in the sums they are the block
/// means. With s^2 their variance, err^2 = 2 tau s^2/m/(1 - 2 tau/m), and err is multiplied by the widening
/// of the decision. Columns that are not linear in the sums have larger errors, or none (nonlinear_errors.h).
///
/// 2 tau is computed from the pseudo-values of all columns of a field in all volumes together
/// (correlation_time.h), and one decision is made for the whole field (error_decision.h). If runs differ by
/// more than their frames explain (between_runs.h), errors come from the spread of the runs; 2 tau is then
/// that within runs, and for single columns the number of blocks divided by that of runs. Quantities that do
/// not fluctuate, or that are undefined without some block, have no error (nan) either.
BlockErrors block_errors(const TimeAverage& average, const Solver& solve,
                         const std::vector<ColumnsOfField>& fields);

/// A column <name>_err for each of `columns`, then effective_samples, then <field>_two_tau for each field.
std::vector<Column> error_columns(const std::vector<Column>& columns,
                                  const std::vector<ColumnsOfField>& fields);

/// Appends these columns.
void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table);

}  // namespace mikromakro
