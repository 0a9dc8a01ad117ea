// SPDX-License-Identifier: GPL-2.0-or-later
// Integrated correlation time of series that are alike, with its uncertainty.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// 2 tau = 1 + 2 sum_k rho_k, rho_k the autocorrelation at the lag k: the variance of the mean of n values is
/// 2 tau/n times that of a value. Times are in steps of the series; uncertainties are relative.
struct CorrelationTime {
  double time = std::numeric_limits<double>::quiet_NaN();  ///< 2 tau of all series; nan: not to be told
  double uncertainty = 0;                                  ///< its standard error
  double scatter = 0;                                      ///< by which 2 tau differs from series to series
  double unknown_scatter = 0;     ///< part of it that of_series does not show, where it is more than chance
  double squares = 1;             ///< sum rho_k^2 over all k, also negative ones
  double square_skewness = 0;     ///< mean over the series, less what normal ones have by chance
  double independent_series = 1;  ///< as many independent series would know 2 tau as well
  Eigen::ArrayXd of_series;       ///< 2 tau of each; nan where it is longer than can be told
  double uncertainty_of_series = 0;
  double most = std::numeric_limits<double>::infinity();  ///< 2 tau is not longer than the longest run
};

/// 2 tau of `series`: a row for each time, a column for each series, which must fluctuate. Values whose
/// `runs` differ are independent; those of one run stand one after the other.
///
/// The correlation of a field is no property of one ring and one column. Mean products at each lag, relative
/// to the variance of their series, are averaged over all series (rho'), and what taking off the mean takes
/// from them is given back: with N_k pairs at the lag k, H_0 = N_0 = n, H_k = 2 N_k and the variance of the
/// mean V = sum H_k C_k/n^2, the products have the expectation C_k - V but for edges, so that C_k = rho'_k +
/// V with V = sum H_k rho'_k/n^2/(1 - sum H_k/n^2) and 2 tau = n V/C_0 (Sokal1989;
/// Wolff2004 Eq. 49). Since the variance of
/// each series is known from itself only, 2 tau comes out smaller by 2 (2 tau - sum rho_k^2)/n, relative; it
/// is divided by that.
///
/// Sums end at the first lag of 1.5 times 2 tau, or later, for as long as the next as many lags add more than
/// 1.5 standard errors. nan where that is beyond a quarter of the series.
///
/// One series knows 2 tau to (2/n) sum_j h_j^2/(2 tau)^2, relative variance, h_j = sum_{|k| <= W} rho_(j-k) -
/// 2 tau rho_j (Bartlett). All of them know it as `independent_series` do, from the mean square of the
/// correlations between series. Where their own values scatter by more than that, each keeps of its own value
/// what the scatter is worth beside the uncertainty (empirical Bayes as in Smyth2004); the rest of the
/// scatter is not told. 2 tau is never below 1. A series that goes on fluctuating slowly behind the window,
/// by four standard errors more than all do, has none (nan): a slow one among many fast ones.
CorrelationTime correlation_time(Rows series, const std::vector<std::int64_t>& runs);

}  // namespace mikromakro
