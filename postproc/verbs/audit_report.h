// SPDX-License-Identifier: GPL-2.0-or-later
// Results of an audit: as text, as JSON, and checked against a bound.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/normal_forces.h"
#include "io/tables/csv_writer.h"
#include "io/tables/json.h"
#include "model/error.h"

namespace mikromakro {

/// Units of stress and of disc volume; without a height these are per length, and an area.
struct AuditUnits {
  std::string stress = "Pa";
  std::string volume = "m^3";
};

/// Relative error of a balance. nan: it could not be evaluated, for the reason given in `text`.
struct Balance {
  std::string name;
  double value;
  std::string text;
  bool judged = true;  ///< false: for information only, for the reason given in `text`
};
using Balances = std::vector<Balance>;

/// The result of an audit.
struct AuditReport {
  Balances balances = {};
  std::string text;  ///< as the program prints it
  Json json;
  Preamble lines = {};  ///< of windows: the header of their table, and this; else no columns
  Table of_windows = {};
  std::optional<Error> off = {};  ///< the first window with a balance that is off
};

/// Normal forces of the discs compared with their overlaps; without k_n, the fraction that is tensile.
Balance law_balance(const NormalForces& forces);

/// The number in the given format, or '-' if it is nan.
std::string number_or_dash(double value, int width, std::string_view format);

void add_balances(std::string& text, const Balances& balances);
void add_balances(Json& json, const Balances& balances);

/// Throws (failed run) if a balance is off by more than the bound, or could not be evaluated. nan: no bound.
void check_bound(const Balances& balances, double bound);
void check_bound(const AuditReport& report, double bound);

}  // namespace mikromakro
