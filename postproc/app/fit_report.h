// SPDX-License-Identifier: GPL-2.0-or-later
// Output of a profile fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/creeping_tail.h"
#include "fit/fit_choices.h"
#include "fit/fit_errors.h"

namespace mikromakro {

struct FitReport {
  std::string column, unit;  ///< the fitted column
  double r_i = 0;
  double omega = 0;
  double scale = 0;  ///< Omega R_i, nan when --omega is not given
  FitWay way;
  double first_r = 0, last_r = 0;  ///< range of the rings used
  ExponentialProfile fitted;
  FitErrors errors;
  double residuals_over_errors = 0;  ///< rms; nan if rings have no errors
  std::vector<FitChoice> choices;
  std::optional<CreepingTail> tail;  ///< with --without-tail
  double s_of_all = 0;               ///< s of the same fit with the tail; nan: no fit
  std::vector<std::string> warnings;
};

void print_json(const FitReport& report);
void print_text(const FitReport& report);

}  // namespace mikromakro
