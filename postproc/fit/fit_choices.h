// SPDX-License-Identifier: GPL-2.0-or-later
// By how much v0 and s depend on how a profile is fitted.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "statistics/exponential_profile.h"

namespace mikromakro {

/// A way to fit a profile, in the rings whose r is in a range.
struct FitWay {
  FitOf of = FitOf::v;
  bool by_errors = false;  ///< weights 1/error^2
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// A profile with an error in each ring, if there are any (empty: none).
struct RingProfile {
  std::string name;  ///< of the table
  Eigen::ArrayXd r, v, error;
};

ExponentialProfile fit_exponential(const RingProfile& profile, double r_i, const FitWay& way);

/// What was said and is not to be varied.
struct FitSaid {
  bool range = false, way = false;
};

struct FitChoice {
  std::string name;
  FitWay way;
  double v0 = std::numeric_limits<double>::quiet_NaN();  ///< nan: no such fit
  double s = std::numeric_limits<double>::quiet_NaN();
};

/// Fits of all profiles in all reasonable ways, of which none is wrong: from the first ring on, or from s/2
/// behind R_i on, where the layers along the wheel end; to the last ring, or to 4 s, where v has fallen to
/// v0/50; of v, of log v (to 4 s only, since the logarithm makes as much of the creep farther out as of all
/// that is before it), and with weights 1/error^2. `way` and its s come from the fit itself; what was said is
/// kept.
std::vector<FitChoice> fit_choices(const std::vector<RingProfile>& profiles, double r_i, const FitWay& way,
                                   double s, const FitSaid& said);

}  // namespace mikromakro
