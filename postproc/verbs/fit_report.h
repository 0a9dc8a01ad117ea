// SPDX-License-Identifier: GPL-2.0-or-later
// Results of a profile fit, as text and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/creeping_tail.h"
#include "fit/fit_choices.h"
#include "fit/fit_errors.h"
#include "io/tables/json.h"

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

Json json_of(const FitReport& report);
std::string text_of(const FitReport& report);

}  // namespace mikromakro
