// SPDX-License-Identifier: GPL-2.0-or-later
// Differences between averages over the same region.
#pragma once

#include <Eigen/Core>

#include "model/table.h"

namespace mikromakro {

/// Difference of a column from a reference, in the unit of the column, over the rows where both are finite.
struct Difference {
  double mean;           ///< of the absolute differences
  double largest;        ///< of the absolute differences
  double rms;            ///< root mean square of the reference
  Eigen::Index rows;     ///< where both are finite; if there are none, all numbers are nan
  Eigen::Index missing;  ///< rows where either is not finite
};

/// `values` and `reference` have the same length. Angles differ by at most half their period (see Column).
/// Never throws.
Difference difference(const Eigen::ArrayXd& values, const Eigen::ArrayXd& reference, double period = 0);

/// The columns of `from` after its coordinates, averaged over the volumes of `onto`: 1/V times the sum of the
/// columns times the intersection volume, over all volumes of `from`, taking the columns as constant in each
/// volume. Exact for columns that are sums over V (Eq. 4) if the volumes of `from` subdivide those of `onto`.
/// Volumes are identified by their columns: r_inner, r_outer, and phi_begin, phi_end for sectors; or x_min,
/// x_max, y_min, y_max. `columns` is the number of columns after the coordinates, in both tables.
Rows averaged_onto(const Table& onto, const Table& from, Eigen::Index columns);

}  // namespace mikromakro
