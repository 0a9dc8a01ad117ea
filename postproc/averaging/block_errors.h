// SPDX-License-Identifier: GPL-2.0-or-later
// Standard errors of solved quantities from block averages.
#pragma once

#include <functional>
#include <limits>

#include "averaging/time_average.h"
#include "statistics/error_decision.h"

namespace mikromakro {

/// Solves columns (volumes x columns) from mean sums.
using Solver = std::function<Rows(const Rows&)>;

/// How the errors of a field were made; times are in frames.
struct FieldErrors {
  ColumnsOfField field;
  Eigen::Index series = 0;  ///< that fluctuate
  CorrelationTime correlation{};
  ErrorDecision decision{};
  /// Of several runs: chi^2 per value of their means about the mean of all, in the errors of each; 1 where
  /// runs differ by what their frames tell, more where packings differ. nan for one run, and without errors.
  double between_runs = std::numeric_limits<double>::quiet_NaN();
};

/// One number per volume and column.
struct BlockErrors {
  Rows error;             ///< standard error; nan where it cannot be known
  Rows correlation_time;  ///< 2 tau, in frames; nan where there is no error
  std::int64_t frames = 0;
  std::vector<FieldErrors> fields;

  /// frames/(2 tau) of the slowest column of each volume, of those with errors; nan where there is none.
  Eigen::ArrayXd effective_samples() const;
  /// 2 tau of the slowest column of each field in each volume.
  Rows times_of_fields() const;
  /// Whether any error is known, and whether all fields have errors.
  bool any() const { return error.isFinite().any(); }
  bool all() const;
};

/// Delete-one-block jackknife of what `solve` gives: the pseudo-values of m blocks are m q - (m - 1) q_i with
/// q_i solved from the mean of all blocks but i. For quantities that are linear in the sums they are the
/// means of the blocks. Of their variance s^2 (over m) the error is made: err^2 = 2 tau s^2/m/(1 - 2 tau/m),
/// times the widening of the decision.
///
/// 2 tau comes from the pseudo-values of all columns of a field in all volumes together (correlation_time.h),
/// and so does the decision whether the field has errors (error_decision.h). Without errors (nan) are also
/// quantities that do not fluctuate, or that are undefined without some block.
BlockErrors block_errors(const TimeAverage& average, const Solver& solve,
                         const std::vector<ColumnsOfField>& fields);

/// Appends to a table a column <name>_err for each of `columns`, then effective_samples, then
/// <field>_two_tau for each field.
void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table);

}  // namespace mikromakro
