// SPDX-License-Identifier: GPL-2.0-or-later
// Errors of v0 and s of a fitted profile.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "averaging/block_table.h"
#include "statistics/exponential_profile.h"

namespace mikromakro {

/// Unknown values are nan; pairs are (v0, s).
struct FitErrors {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Array2d error = {nan, nan};       ///< standard errors
  Eigen::Array2d half_width = {nan, nan};  ///< of the 95 % confidence intervals
  double correlation = nan;                ///< between v0 and s
  std::string method = "none";
  std::string remark;                         ///< what the errors are based on, or why there are none
  double two_tau = nan, two_tau_error = nan;  ///< in frames
  double samples = nan, freedom = nan;        ///< effective samples, degrees of freedom
};

/// Fits other values of v in place of those of the profile.
using FitValues = std::function<ExponentialProfile(const Eigen::ArrayXd&)>;

/// Jackknife: the profile without each block of frames is fitted, and the pseudo-values of v0, of s and of v
/// in each ring of `fitted` form one field for block_errors. Correlations between rings are thus included
/// through the fluctuations of v0 and s. The 2 tau used is not below that of the rings that determine v0 and
/// s, which fluctuate differently from most; that estimate is less certain, so the larger of the two is used.
/// With eight or more runs each run is one block, and errors use Student's t with one degree of freedom fewer
/// than runs: variation between runs that does not show within one is then included. The same applies if
/// fewer runs differ by more than their frames explain (between_runs.h); three or fewer have no errors then.
FitErrors errors_from_blocks(const ExponentialProfile& fitted, const ColumnWithoutBlocks& blocks,
                             const FitValues& fit);

/// From the standard errors of the rings alone. These do not contain the correlations between rings, nor can
/// residuals show them, since v0 and s are determined by three or four independent rings. sum |d v0/d v_i|
/// error_i is the standard error of v0 if all rings act in the same direction. It is a rough number, not a
/// bound: it inherits any fault in the errors of the rings that determine v0 (docs/manual/errors.md).
FitErrors errors_from_rings(const ExponentialProfile& fitted, const Eigen::ArrayXd& error_of_ring);

}  // namespace mikromakro
