// SPDX-License-Identifier: GPL-2.0-or-later
// Sensitivity of v0 and s to the choices made in a fit.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "statistics/exponential_profile.h"

namespace mikromakro {

/// A way to fit a profile, restricted to the rings with r in a range.
struct FitWay {
  FitOf of = FitOf::v;
  bool by_errors = false;  ///< weights 1/error^2
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// A profile, with an error for each ring if available (else empty).
struct RingProfile {
  std::string name;  ///< file name of the table
  Eigen::ArrayXd r, v, error;
};

ExponentialProfile fit_exponential(const RingProfile& profile, double r_i, const FitWay& way);

/// Choices made by the user, which are not varied.
struct FitSaid {
  bool range = false, way = false;
};

struct FitChoice {
  std::string name;
  FitWay way;
  double v0 = std::numeric_limits<double>::quiet_NaN();  ///< nan: this fit failed
  double s = std::numeric_limits<double>::quiet_NaN();
  std::string missing = {};  ///< the reason, in this case
};

/// Fits all profiles in all reasonable ways: from the first ring, or from s/2 beyond R_i, where the layering
/// along the wheel ends; up to the last ring, or up to 4 s, where v has fallen to v0/50; of v, of log v (up
/// to 4 s only, because the logarithm gives the creep farther out as much weight as everything before it),
/// and with weights 1/error^2. `way` and its s are those of the main fit; user choices are kept.
std::vector<FitChoice> fit_choices(const std::vector<RingProfile>& profiles, double r_i, const FitWay& way,
                                   double s, const FitSaid& said);

}  // namespace mikromakro
