// SPDX-License-Identifier: GPL-2.0-or-later
// How far averages over the same region lie apart.
#pragma once

#include <Eigen/Core>

#include "model/table.h"

namespace mikromakro {

/// Of a column from a reference, in its unit, over the rows in which both are finite.
struct Difference {
  double mean;           ///< of the absolute differences
  double largest;        ///< of the absolute differences
  double rms;            ///< root mean square of the reference
  Eigen::Index rows;     ///< in which both are finite; all numbers are nan where there are none
  Eigen::Index missing;  ///< in which either is not
};

/// `values` and `reference` have the same length. Angles differ by half of their period (see Column) at most.
/// Never throws.
Difference difference(const Eigen::ArrayXd& values, const Eigen::ArrayXd& reference, double period = 0);

/// The columns of `from` behind those that tell where its volumes lie, averaged over the volumes of `onto`:
/// 1/V times the sum over all volumes of `from` of the volume that both have in common, where the columns are
/// taken as constant over each volume. For columns that are sums over V (Eq. 4) and volumes of `from` that
/// divide those of `onto`, the result is exact. Volumes are found by their columns: r_inner, r_outer, and
/// phi_begin, phi_end for sectors; or x_min, x_max, y_min, y_max. `columns` is the number of columns behind
/// the coordinates, in both.
Rows averaged_onto(const Table& onto, const Table& from, Eigen::Index columns);

}  // namespace mikromakro
