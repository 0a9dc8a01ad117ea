// SPDX-License-Identifier: GPL-2.0-or-later
// How often the errors of deviators, principal values, directions and mu_c cover the truth, where the tensor
// is weakly anisotropic or isotropic and where the curvature is small.
#pragma once

namespace mikromakro::bench {

/// Prints one table for principal axes and one for mu_c, for deviators and curvatures of 0 to 40
/// standard deviations of the mean of a component.
void print_tensor_coverage(int trials);

}  // namespace mikromakro::bench
