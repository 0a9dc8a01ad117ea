// Exponential velocity profile of a shear zone.
#pragma once

#include <Eigen/Core>

namespace mikromakro {

/// A fitted parameter and its confidence interval.
struct Estimate {
  double value = 0;
  double low = 0;
  double high = 0;
};

struct ExponentialProfile {
  Estimate v0;  ///< velocity at R_i, in the unit of v
  Estimate s;   ///< width of the shear zone, in the unit of r
  int points = 0;
  double residual_rms = 0;  ///< sqrt(mean (v - fit)^2), in the unit of v
};

/// Points of a profile; `error` (standard error of v) may be empty: then all count the same. Points where v
/// (or its error) is not finite are left out.
struct ProfilePoints {
  Eigen::ArrayXd r;
  Eigen::ArrayXd v;
  Eigen::ArrayXd error;
};

/// Least squares of v(r) = v0 exp(-(r - r_i)/s) (seed, Bild 5), weights 1/error^2, by Levenberg-Marquardt. v0
/// may be negative (a wheel that turns clockwise). 95 % intervals v +- t C^(1/2), C = S/(n - 2) (J^T W J)^-1
/// with S the weighted sum of squares: errors count relative to each other, their common size comes from the
/// scatter. Throws (failed run): fewer than 3 points, no convergence to a decaying profile.
ExponentialProfile fit_exponential(const ProfilePoints& points, double r_i);

}  // namespace mikromakro
