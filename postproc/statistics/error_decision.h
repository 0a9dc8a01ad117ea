// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a field gets error bars, and how wide they are.
#pragma once

#include "statistics/correlation_time.h"

namespace mikromakro {

/// One decision for all columns of a field in all volumes: selecting single columns by their own estimates
/// would favour those whose correlation time came out too small.
struct ErrorDecision {
  bool given = false;
  bool unlike = false;   ///< no errors, because 2 tau varies between series by more than their uncertainty
  bool by_runs = false;  ///< only the spread of runs tells: decide_by_runs
  double samples = 0;    ///< effective samples, n/(2 tau); by runs, their effective number
  double needed = 0;     ///< minimum required for an error
  double freedom = 0;    ///< degrees of freedom of the error
  double widening = 1;
};

/// For series of `count` values. Fields are subject to the same selection effect as series: among fields with
/// few samples, those whose 2 tau came out small get errors. This is harmless if 2 tau is well determined,
/// hence:
/// - its standard error must be at most a fifth of it, so that errors are right to a tenth; as it falls as
///   1/sqrt(samples), few series need many samples;
/// - with 2 tau increased by its standard error there must be 8 effective samples;
/// - if series differ, their own 2 tau must account for the variation up to a tenth.
/// With eight runs, which are independent anyway, eight samples suffice.
///
/// Near the limit, 2 tau is still biased towards series in which it came out small, unless it is 1 anyway: it
/// is increased by needed/samples (1 - 1/T) standard errors, T being its value plus one standard error.
///
/// The squared error has the relative variance 2 sum rho_k^2/n of the variance plus that of 2 tau, together
/// 2/freedom; errors are multiplied by `widening` so that one standard error covers 68.3 % and 1.96 of them
/// 95 %, as well as one number can (student_width, skewed_width). No errors below three degrees of freedom.
ErrorDecision decide(const CorrelationTime& correlation, double count);

/// For runs that differ by more than their frames tell, or change as slowly as they last: errors come from
/// the spread of the runs, of `freedom` degrees of freedom, if these are three or more. `samples` is freedom
/// + 1.
ErrorDecision decide_by_runs(double freedom);

/// Mean of the t quantile of 68.27 % and that of 95 % over 1.96.
double student_width(double freedom);

/// The same for skewed samples: quantiles x of Student's t widen by g^2 (x^4 + 2 x^2 - 3)/18/n, relative,
/// with the skewness g (Hall1992 on Student's t); for n samples
/// g^2 is too small by (n - 2)^2/n/(n - 1).
double skewed_width(double square_skewness, double samples);

}  // namespace mikromakro
