// SPDX-License-Identifier: GPL-2.0-or-later
// The balances that an audit ends with: as lines, as JSON, against a bound.
#pragma once

#include <string>
#include <vector>

#include "audit/normal_forces.h"
#include "io/tables/json_object.h"

namespace mikromakro {

/// Of stresses and of the volume of discs; without a height per length, and an area.
struct AuditUnits {
  std::string stress = "Pa";
  std::string volume = "m^3";
};

/// By which part a balance is off. nan: it cannot be made, for the reason that stands in the text.
struct Balance {
  std::string name;
  double value;
  std::string text;
  bool judged = true;  ///< false: shown only, for the reason that stands in the text
};
using Balances = std::vector<Balance>;

/// The normal forces of discs beside their overlaps; without k_n the part of them that pulls.
Balance law_balance(const NormalForces& forces);

/// The number in the given format, or '-' in its place where it is nan.
std::string number_or_dash(double value, int width, std::string_view format);

void print_balances(const Balances& balances);
void add_balances(JsonObject& json, const Balances& balances);

/// Throws (a failed run) when a balance is off by more than the bound; one that cannot be made is off, too.
/// No bound: nan.
void check_bound(const Balances& balances, double bound);

}  // namespace mikromakro
