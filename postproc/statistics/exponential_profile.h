// SPDX-License-Identifier: GPL-2.0-or-later
// Exponential velocity profile of a shear zone.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace mikromakro {

struct ExponentialProfile {
  double v0 = 0;                   ///< velocity at R_i, in the unit of v
  double s = 0;                    ///< width of the shear zone, in the unit of r
  double residual_rms = 0;         ///< sqrt(mean (v - fit)^2), in the unit of v
  std::vector<Eigen::Index> used;  ///< indices of the points that were used
  Eigen::Matrix2Xd change;         ///< d(v0, s)/dv (rows) at each of these points
};

/// Points of a profile. `error` (standard error of v) may be empty: equal weights. Points with a non-finite v
/// or error are ignored.
struct ProfilePoints {
  Eigen::ArrayXd r;
  Eigen::ArrayXd v;
  Eigen::ArrayXd error;
};

/// Quantity whose squared residuals are minimised.
enum class FitOf { v, log_v };

/// Least-squares fit of v(r) = v0 exp(-(r - r_i)/s) (Latzel2001 Bild 5), weights 1/error^2, by
/// Levenberg-Marquardt; or of the straight line log v, weights (v/error)^2. v0 may be negative (wheel turning
/// clockwise). Throws (failed run): fewer than 3 points, no convergence to a decaying profile, a profile that
/// falls below a millionth from the first ring to the next, log_v of values of both signs.
ExponentialProfile fit_exponential(const ProfilePoints& points, double r_i, FitOf of = FitOf::v);

}  // namespace mikromakro
