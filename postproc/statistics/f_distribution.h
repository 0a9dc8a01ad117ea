// SPDX-License-Identifier: GPL-2.0-or-later
// Tail of the F distribution, for ratios of variances.
#pragma once

namespace mikromakro {

/// P(F > ratio) for `above` and `below` > 0 degrees of freedom of the numerator and the denominator:
/// I_x(below/2, above/2) with x = below/(below + above ratio).
double f_tail(double ratio, double above, double below);

}  // namespace mikromakro
