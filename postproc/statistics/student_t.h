// SPDX-License-Identifier: GPL-2.0-or-later
// Quantile of Student's t distribution, for confidence intervals.
#pragma once

namespace mikromakro {

/// The t with P(|T| <= t) = confidence (0 < confidence < 1) for `freedom` > 0 degrees of freedom: P(|T| > t)
/// = I_x(freedom/2, 1/2) with x = freedom/(freedom + t^2), I the regularised incomplete beta function. Solved
/// to 1e-12.
double student_t(double confidence, double freedom);

}  // namespace mikromakro
