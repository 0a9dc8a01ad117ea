// The balances that an audit ends with: as lines, as JSON, against a bound.
#pragma once

#include <string>
#include <vector>

#include "io/json_object.h"

namespace mikromakro {

/// By which part a balance is off.
struct Balance {
  std::string name;
  double value;
  std::string text;
  bool judged = true;  ///< false: shown only, for the reason that stands in the text
};
using Balances = std::vector<Balance>;

void print_balances(const Balances& balances);
void add_balances(JsonObject& json, const Balances& balances);

/// Throws (a failed run) when a balance is off by more than the bound; a balance that is not known is off,
/// too. No bound: nan.
void check_bound(const Balances& balances, double bound);

}  // namespace mikromakro
