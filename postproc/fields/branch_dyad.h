// SPDX-License-Identifier: GPL-2.0-or-later
// The sum of l (x) l over contacts: what a least-squares fit over the branch vectors is solved with.
#pragma once

#include <Eigen/Core>
#include <span>

#include "fields/field.h"

namespace mikromakro {

/// Numbers that the sum takes: rr, rphi, phiphi (it is symmetric).
inline constexpr int branch_dyad_sums = 3;

/// Adds sum_c l (x) l (m^2) of a disc. For l = a_p n it is V/(pi h) times the disc's part of F (Latzel2001
/// Table 1), so that the least squares of Latzel2001 Eqs. 18-20 have one form for every choice of the branch
/// vector.
void add_branch_dyad(std::span<const DiscContact> contacts, std::span<double> sums);

/// Its inverse (1/m^2); all nan where the contacts do not span the plane: smallest below 1e-12 times the
/// largest singular value, or no contacts. 1e-12 is far above the rounding of sums and far below any packing.
Eigen::Matrix2d inverse_branch_dyad(std::span<const double> sums);

}  // namespace mikromakro
