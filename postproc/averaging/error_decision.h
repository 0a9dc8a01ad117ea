// Whether a field has errors, and how wide they are.
#pragma once

#include "averaging/correlation_time.h"

namespace mikromakro {

/// For all columns of a field in all volumes at once: picking single ones by their own estimates would pick
/// those whose correlation came out too small.
struct ErrorDecision {
  bool given = false;
  double samples = 0;  ///< effective samples, n/(2 tau)
  double needed = 0;   ///< at least, for an error
  double freedom = 0;  ///< degrees of freedom that an error has
  double widening = 1;
};

/// For series of `count` values. Needed are 6 exp(1.8/sqrt(independent_series)) effective samples, at least
/// 8: a series of 6 samples knows 2 tau to 0.6, so that 2 tau is three standard errors (of its logarithm)
/// below what would leave 6. A field of few series needs more: 36 a single one,
/// unless eight runs are independent anyway. Near that limit 2 tau is told
/// by those series in which it came out small, unless it is 1 anyway: it is made larger by needed/samples (1
/// - 1/T) of its standard error, T its value and three of them.
///
/// The squared error has the relative variance 2 sum rho_k^2/n of the variance and that of 2 tau, together
/// 2/freedom; errors are `widening` times wider, so that one of them covers 68.3 % and 1.96 of them 95 % as
/// well as one number can (student_width). With fewer than three degrees of freedom there are none.
ErrorDecision decide(const CorrelationTime& correlation, double count);

/// Mean of the t quantile of 68.27 % and of that of 95 % over 1.96.
double student_width(double freedom);

}  // namespace mikromakro
