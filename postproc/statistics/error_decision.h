// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a field gets error bars, and how wide they are.
#pragma once

#include "statistics/correlation_time.h"

namespace mikromakro {

/// One decision for all columns of a field in all volumes: selecting columns by their individual estimates
/// would favour those whose correlation time is underestimated.
struct ErrorDecision {
  bool given = false;
  bool unlike = false;   ///< no errors, because 2 tau varies between series by more than their uncertainty
  bool by_runs = false;  ///< errors come from the spread of the runs only: decide_by_runs
  double samples = 0;    ///< effective samples, n/(2 tau); by runs, their effective number
  double needed = 0;     ///< minimum required for an error
  double freedom = 0;    ///< degrees of freedom of the error
  double widening = 1;
};

/// For series of `count` values. Fields are subject to the same selection effect as series: among fields with
/// few samples, those whose 2 tau is underestimated get errors. This is harmless if 2 tau is well determined,
/// hence:
/// - its standard error must be at most a fifth of 2 tau, so that errors are accurate to a tenth; since it
/// falls as 1/sqrt(samples), few series need many samples;
/// - with 2 tau increased by its standard error there must be 8 effective samples;
/// - if series differ, the 2 tau of each must account for the variation up to a tenth.
/// With eight runs, which are independent anyway, eight samples suffice.
///
/// Near the limit, 2 tau is still biased towards series in which it is underestimated, unless it is 1 anyway:
/// it is increased by needed/samples (1 - 1/T) standard errors, T being its value plus one standard error.
///
/// The squared error has a relative variance of 2 sum rho_k^2/n from the variance plus that of 2 tau,
/// together 2/freedom. Errors are multiplied by `widening` so that one standard error covers 68.3 % and 1.96
/// of them 95 %, as well as a single factor can (student_width, skewed_width). No errors below three degrees
/// of freedom.
ErrorDecision decide(const CorrelationTime& correlation, double count);

/// For runs that differ by more than their frames explain, or that change as slowly as they last: errors come
/// from the spread of the runs, with `freedom` degrees of freedom, if these are three or more. `samples` is
/// freedom + 1.
ErrorDecision decide_by_runs(double freedom);

/// Mean of the 68.27 % quantile of t and of its 95 % quantile divided by 1.96.
double student_width(double freedom);

/// The same for skewed samples: the quantiles x of Student's t widen by g^2 (x^4 + 2 x^2 - 3)/18/n, relative,
/// with the skewness g (Hall1992 on Student's t); from n samples, g^2 is underestimated by the factor (n -
/// 2)^2/n/(n - 1).
double skewed_width(double square_skewness, double samples);

}  // namespace mikromakro
