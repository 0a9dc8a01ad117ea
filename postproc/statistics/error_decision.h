// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a field has errors, and how wide they are.
#pragma once

#include "statistics/correlation_time.h"

namespace mikromakro {

/// For all columns of a field in all volumes at once: picking single ones by their own estimates would pick
/// those whose correlation came out too small.
struct ErrorDecision {
  bool given = false;
  bool unlike = false;  ///< none, since 2 tau differs from series to series by more than they know
  double samples = 0;   ///< effective samples, n/(2 tau)
  double needed = 0;    ///< at least, for an error
  double freedom = 0;   ///< degrees of freedom that an error has
  double widening = 1;
};

/// For series of `count` values. The same holds for fields as for series: among those of few samples, errors
/// are given where 2 tau came out small. That does no harm where 2 tau is known well:
/// - its standard error must be a fifth of it or less, so that errors are right to a tenth; it falls as
///   1/sqrt(samples), so that many are needed where there are few series;
/// - with 2 tau larger by its standard error there must be 8 effective samples;
/// - where series differ, their own 2 tau must show it but for a tenth.
/// Where eight runs are independent anyway, eight samples do.
///
/// Near the limit, 2 tau is still told by those series in which it came out small, unless it is 1 anyway: it
/// is made larger by needed/samples (1 - 1/T) of its standard error, T its value and one of them.
///
/// The squared error has the relative variance 2 sum rho_k^2/n of the variance and that of 2 tau, together
/// 2/freedom; errors are `widening` times wider, so that one of them covers 68.3 % and 1.96 of them 95 % as
/// well as one number can (student_width, skewed_width). With fewer than three degrees of freedom there are
/// none.
ErrorDecision decide(const CorrelationTime& correlation, double count);

/// Mean of the t quantile of 68.27 % and of that of 95 % over 1.96.
double student_width(double freedom);

/// The same for samples that are skewed: quantiles x of Student's t become wider by g^2 (x^4 + 2 x^2 -
/// 3)/18/n, relative, with the skewness g (Hall1992 on Student's t); g^2 of n samples is too small by (n -
/// 2)^2/n/(n - 1).
double skewed_width(double square_skewness, double samples);

}  // namespace mikromakro
