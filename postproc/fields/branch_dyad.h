// SPDX-License-Identifier: GPL-2.0-or-later
// Sum of l (x) l over contacts: the normal matrix of least-squares fits over branch vectors.
#pragma once

#include <Eigen/Core>
#include <span>

#include "fields/field.h"

namespace mikromakro {

/// Numbers per sum: rr, rphi, phiphi (the dyad is symmetric).
inline constexpr int branch_dyad_sums = 3;

/// Adds sum_c l (x) l (m^2) of one disc. For l = a_p n this is V/(pi h) times the disc's contribution to F
/// (Latzel2001 Table 1), so the least squares of Latzel2001 Eqs. 18-20 take one form for every choice of
/// branch vector.
void add_branch_dyad(std::span<const DiscContact> contacts, std::span<double> sums);

/// Inverse of the sum (1/m^2). All nan if the contacts do not span the plane: no contacts, or the smallest
/// singular value is below 1e-12 times the largest. 1e-12 is far above the rounding of the sums and far below
/// the ratio in any packing.
Eigen::Matrix2d inverse_branch_dyad(std::span<const double> sums);

}  // namespace mikromakro
