// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/f_distribution.h"

#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace mikromakro {

double f_tail(double ratio, double above, double below) {
  if (!(ratio > 0)) return 1;
  return Eigen::numext::betainc(0.5 * below, 0.5 * above, below / (below + above * ratio));
}

}  // namespace mikromakro
