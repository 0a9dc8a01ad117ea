// SPDX-License-Identifier: GPL-2.0-or-later
// Errors of v0 and s of a fitted profile.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "averaging/block_table.h"
#include "statistics/exponential_profile.h"

namespace mikromakro {

/// What is not known is nan; pairs are of v0 and s.
struct FitErrors {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Array2d error = {nan, nan};       ///< standard errors
  Eigen::Array2d half_width = {nan, nan};  ///< of the intervals of 95 %
  double correlation = nan;                ///< of v0 with s
  std::string method = "none";
  std::string remark;                         ///< what the errors rest on, or why there are none
  double two_tau = nan, two_tau_error = nan;  ///< in frames
  double samples = nan, freedom = nan;        ///< effective samples, degrees of freedom
};

/// Fits values of v in place of those of the profile.
using FitValues = std::function<ExponentialProfile(const Eigen::ArrayXd&)>;

/// Jackknife: each profile without a block of frames is fitted, and the pseudo-values of v0, of s and of v in
/// each ring of `fitted` are a field of the table for block_errors. However rings fluctuate together, and
/// where, is in how v0 and s fluctuate. Their 2 tau is not taken below that of the rings of which they are
/// told, which fluctuate otherwise than most: this one is known less well, and the larger of two counts. Of
/// eight runs or more each run counts as one block, and errors have Student's t of one degree of freedom less
/// than there are runs: what differs from run to run and not within one is counted then.
FitErrors errors_from_blocks(const ExponentialProfile& fitted, const ColumnWithoutBlocks& blocks,
                             const FitValues& fit);

/// From the standard errors of the rings alone. How rings fluctuate together is not in them, and residuals do
/// not tell either, since v0 and s come from three or four independent rings. But sum |d v0/d v_i| error_i is
/// the standard error of v0 when all work together, and never too small: the errors are upper bounds.
FitErrors errors_from_rings(const ExponentialProfile& fitted, const Eigen::ArrayXd& error_of_ring);

}  // namespace mikromakro
