// Standard errors of solved quantities from block averages.
#pragma once

#include <functional>

#include "averaging/time_average.h"

namespace mikromakro {

/// Solves columns (volumes x columns) from mean sums.
using Solver = std::function<Rows(const Rows&)>;

/// One number per volume and column.
struct BlockErrors {
  Rows error;             ///< standard error; nan where it cannot be known
  Rows correlation_time;  ///< 2 tau_int, in frames; nan where there is no error
  std::int64_t frames = 0;

  /// frames/(2 tau) of the slowest column of each volume; nan where none is known.
  Eigen::ArrayXd effective_samples() const;
  /// Whether any error is known.
  bool any() const { return error.isFinite().any(); }
};

/// Delete-one-block jackknife of what `solve` gives: for m blocks err^2 = 2 tau (m - 1)/m sum_i (q_i - mean
/// q)^2 with q_i solved from the mean of all blocks but i. For quantities that are linear in the sums it is
/// the standard error of the mean of the blocks; the factor is for blocks that depend on each other.
///
/// 2 tau = 1 + 2 sum rho_k, the integrated correlation time in blocks, comes from the pseudo-values m q - (m
/// - 1) q_i up to the lag of 1.5 times itself (Sokal's window), from blocks of the same run, and is taken as
/// 1 where it comes out smaller. No error is given (nan) for fewer than 16 independent blocks, m < 16 * 2
/// tau: the estimate of tau itself would be too small; nor for quantities that do not fluctuate, or that are
/// undefined without some block.
BlockErrors block_errors(const TimeAverage& average, const Solver& solve);

/// Appends to a table a column <name>_err for each of `columns`, then effective_samples.
void append_errors(const BlockErrors& errors, const std::vector<Column>& columns, Table& table);

}  // namespace mikromakro
