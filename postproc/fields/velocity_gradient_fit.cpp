// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/velocity_gradient_fit.h"

#include <limits>

#include "model/error.h"
#include "statistics/exponential_profile.h"

namespace mikromakro {

std::vector<Column> VelocityGradientFit::columns(const Axes& axes) const {
  const std::string both = axes[0] + axes[1];
  return {{"D_" + both + "_fit", "1/s", "Latzel2001 Eq. 9", "rate of deformation, exponential fit"},
          {"W_" + both + "_fit", "1/s", "Latzel2001 Eq. 9", "rate of rotation, exponential fit"}};
}

void VelocityGradientFit::solve(const VolumeData& volumes, const ConstRowsRef& numbers,
                                RowsRef columns) const {
  columns = std::numeric_limits<double>::quiet_NaN();
  const Eigen::ArrayXd& r = volumes.radius;
  if (r.size() == 0) return;
  try {
    const ExponentialProfile fit = fit_exponential({r, numbers.col(1), {}}, r[0]);
    const Eigen::ArrayXd half = 0.5 * fit.v0 * (-(r - r[0]) / fit.s).exp();
    columns.col(0) = -half * (1 / fit.s + 1 / r);
    columns.col(1) = -half * (1 / fit.s - 1 / r);
  } catch (const Error&) {
    // No such profile: the columns stay nan.
  }
}

}  // namespace mikromakro
