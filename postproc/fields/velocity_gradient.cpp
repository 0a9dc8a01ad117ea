// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/velocity_gradient.h"

#include <algorithm>
#include <limits>

namespace mikromakro {
namespace {

// Slope at x of the parabola through the three points from i on, by Newton's divided differences.
double parabola_slope(const Eigen::ArrayXd& r, const Eigen::ArrayXd& v, Eigen::Index i, double x) {
  const double first = (v[i + 1] - v[i]) / (r[i + 1] - r[i]);
  const double second = (v[i + 2] - v[i + 1]) / (r[i + 2] - r[i + 1]);
  const double bend = (second - first) / (r[i + 2] - r[i]);
  return first + bend * (2 * x - r[i] - r[i + 1]);
}

}  // namespace

Eigen::ArrayXd slopes(const Eigen::ArrayXd& r, const Eigen::ArrayXd& v) {
  const Eigen::Index count = r.size();
  if (count < 2) return Eigen::ArrayXd::Constant(v.size(), std::numeric_limits<double>::quiet_NaN());
  if (count == 2) return Eigen::ArrayXd::Constant(2, (v[1] - v[0]) / (r[1] - r[0]));
  Eigen::ArrayXd slope(count);
  for (Eigen::Index i = 0; i < count; ++i)
    slope[i] = parabola_slope(r, v, std::clamp<Eigen::Index>(i - 1, 0, count - 3), r[i]);
  return slope;
}

std::vector<Column> VelocityGradient::columns(const Axes& axes) const {
  const std::string both = axes[0] + axes[1];
  return {{"D_" + both, "1/s", "Latzel2001 Eq. 7", "rate of deformation, finite differences"},
          {"W_" + both, "1/s", "Latzel2001 Eq. 8", "rate of rotation, finite differences"},
          {"omega_excess", "1/s", "Latzel2001 Bild 11", "spin - W_" + both}};
}

void VelocityGradient::solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const {
  if (volumes.radius.size() == 0) {
    columns = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const Eigen::ArrayXd v = numbers.col(1);
  const Eigen::ArrayXd slope = slopes(volumes.radius, v);
  columns.col(0) = 0.5 * (slope - v / volumes.radius);
  columns.col(1) = 0.5 * (slope + v / volumes.radius);
  columns.col(2) = numbers.col(2) - columns.col(1);
}

}  // namespace mikromakro
