// SPDX-License-Identifier: GPL-2.0-or-later
// Delete-one-block jackknife of solved quantities, and how far they are from linear in the sums.
#pragma once

#include <functional>

#include "fields/field.h"

namespace mikromakro {

/// Computes columns (volumes x columns) from mean sums.
using Solver = std::function<Rows(const Rows&)>;

struct PseudoValues {
  std::vector<Rows> deviations;  ///< deviation of each block from the whole
  Rows variance;
  /// How much the values bend over the range of their error: the mean of the values of two halves of the
  /// blocks, a and b, minus the value q of all, (q(a) + q(b))/2 - q, root mean square over seven divisions
  /// into halves. The halves differ from the whole as much as the whole does from the truth, so that this is
  /// the second-order term of q at a displacement by one standard error: 0 where q is linear in the sums,
  /// 3^0.5 s^2/(2 D) for a deviator D whose components have the standard error s. It falls as 1/n, the error
  /// as n^-1/2. nan where q is undefined in a half of each division.
  Rows curvature;
  /// Whether the series varies beyond rounding, and in enough blocks.
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> fluctuate;
};

/// The pseudo-values of m >= 8 blocks are m q - (m - 1) q_i, with q from the mean of all blocks and q_i from
/// that of all but block i. Halves are four of eight groups of successive blocks, by the seven Walsh
/// functions that are not constant.
PseudoValues pseudo_values(const std::vector<Rows>& blocks, const Solver& solve,
                           const std::vector<ColumnsOfField>& fields);

}  // namespace mikromakro
