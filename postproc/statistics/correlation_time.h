// SPDX-License-Identifier: GPL-2.0-or-later
// Integrated correlation time of a set of similar series, with its uncertainty.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "statistics/lagged_products.h"

namespace mikromakro {

/// 2 tau = 1 + 2 sum_k rho_k, with rho_k the autocorrelation at lag k: the variance of the mean of n values
/// is 2 tau/n times that of one value. Times are in steps of the series; uncertainties are relative.
struct CorrelationTime {
  double time = std::numeric_limits<double>::quiet_NaN();  ///< 2 tau of all series; nan: undetermined
  double uncertainty = 0;                                  ///< its standard error
  double scatter = 0;                                      ///< variation of 2 tau between series
  double unknown_scatter = 0;     ///< the part that of_series does not show, if it exceeds chance
  double squares = 1;             ///< sum rho_k^2 over all k, negative ones included
  double square_skewness = 0;     ///< mean over the series, minus the value that normal series have by chance
  double independent_series = 1;  ///< number of independent series that would determine 2 tau equally well
  Eigen::ArrayXd of_series;       ///< 2 tau of each; nan if too long to be determined
  double uncertainty_of_series = 0;
  double most = std::numeric_limits<double>::infinity();  ///< 2 tau is at most the longest run
};

/// 2 tau of `series`: one row per time, one column per series; every series must fluctuate. Values with
/// different `runs` are independent; the values of one run are contiguous.
///
/// The correlation of a field is not specific to one ring and one column, so the mean products at each lag,
/// relative to the variance of their series, are averaged over all series (rho'), and the bias due to
/// subtracting the mean is corrected: with N_k pairs at lag k, H_0 = N_0 = n, H_k = 2 N_k and the variance of
/// the mean V = sum H_k C_k/n^2, the products have the expectation C_k - V up to edge effects, so that C_k =
/// rho'_k + V with V = sum H_k rho'_k/n^2/(1 - sum H_k/n^2) and 2 tau = n V/C_0 (Sokal1989; Wolff2004 Eq.
/// 49). Since the variance of each series is estimated from that series alone, 2 tau comes out too small by 2
/// (2 tau - sum rho_k^2)/n, relative; the result is divided accordingly.
///
/// Sums end at the first lag beyond 1.5 times 2 tau, or later, as long as the next equal number of lags adds
/// more than 1.5 standard errors. nan if the end lies beyond a quarter of the series.
///
/// One series determines 2 tau with the relative variance (2/n) sum_j h_j^2/(2 tau)^2, h_j = sum_{|k| <= W}
/// rho_(j-k) - 2 tau rho_j (Bartlett). All series together determine it like `independent_series` independent
/// ones, computed from the mean square of the correlations between series. If the individual values scatter
/// by more than that, each is shrunk towards the common value and keeps the fraction scatter/(scatter +
/// uncertainty) of its deviation, in variances (empirical Bayes as in Smyth2004); the rest of the scatter is
/// unknown. 2 tau is never below 1. A series that keeps fluctuating slowly beyond the window, by four
/// standard errors more than all series do, has no value (nan): a slow one among many fast ones.
///
/// About the means of the runs, the products at lag k lack sum_r (n_r - k)/n_r n/N_k times V in place of V,
/// with n_r values in run r; lags go to half of the longest run.
CorrelationTime correlation_time(Rows series, const std::vector<std::int64_t>& runs,
                                 About about = About::common_mean);

}  // namespace mikromakro
