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
  std::vector<Eigen::Index> used;  ///< which of the points
  Eigen::Matrix2Xd change;         ///< of v0 and of s (rows) with v of each of these
};

/// Points of a profile; `error` (standard error of v) may be empty: then all count the same. Points where v
/// (or its error) is not finite are left out.
struct ProfilePoints {
  Eigen::ArrayXd r;
  Eigen::ArrayXd v;
  Eigen::ArrayXd error;
};

/// Of what the squares are least.
enum class FitOf { v, log_v };

/// Least squares of v(r) = v0 exp(-(r - r_i)/s) (Latzel2001 Bild 5), weights 1/error^2, by
/// Levenberg-Marquardt; or of the straight line log v, weights (v/error)^2. v0 may be negative (a wheel that
/// turns clockwise). Throws (failed run): fewer than 3 points, no convergence to a decaying profile, one
/// that falls to less than a millionth from the first ring to the next, a logarithm of values that have not
/// one sign.
ExponentialProfile fit_exponential(const ProfilePoints& points, double r_i, FitOf of = FitOf::v);

}  // namespace mikromakro
