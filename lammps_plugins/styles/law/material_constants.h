// SPDX-License-Identifier: GPL-2.0-or-later
// Material constants of the contact law: those that a law needs, as the pair loop reads them, and as the
// script gives them.
#pragma once

#include <string>
#include <vector>

#include "law/type_pair_table.h"
#include "physics/contact/contact_law.h"

namespace mikromakro::styles {

/// The constants that contacts between discs of two types are evaluated with.
using MaterialTable = TypePairTable<physics::ContactParameters>;

/// A material constant as given in the script, for output files: one value for each pair of types, row by
/// row as in TypePairTable::values().
struct MaterialConstant {
  std::string name, unit;
  std::vector<double> values;
  bool operator==(const MaterialConstant& other) const {
    return name == other.name && unit == other.unit && values == other.values;
  }
};

/// True if a law with these effects uses the constant.
bool is_needed(double physics::ContactParameters::*constant, const physics::Effects& effects);

}  // namespace mikromakro::styles
