// SPDX-License-Identifier: GPL-2.0-or-later
// What the fit of a profile prints.
#pragma once

#include <string>
#include <vector>

#include "fit/fit_choices.h"
#include "fit/fit_errors.h"

namespace mikromakro {

struct FitReport {
  std::string column, unit;  ///< that is fitted
  double r_i = 0;
  double omega = 0;
  double scale = 0;  ///< Omega R_i, nan when --omega is not given
  FitWay way;
  double first_r = 0, last_r = 0;  ///< of the rings that are used
  ExponentialProfile fitted;
  FitErrors errors;
  double residuals_over_errors = 0;  ///< rms, nan where rings have no errors
  std::vector<FitChoice> choices;
};

void print_json(const FitReport& report);
void print_text(const FitReport& report);

}  // namespace mikromakro
