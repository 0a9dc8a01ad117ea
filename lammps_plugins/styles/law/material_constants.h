// SPDX-License-Identifier: GPL-2.0-or-later
// Material constants of the contact law: the table of all, which of them a law needs, their values as the
// pair loop reads them, and as the script gives them.
#pragma once

#include <array>
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

/// A constant of physics::ContactParameters, as scripts, messages and output files name it.
struct ConstantOfLaw {
  const char* name;     // in output files and in fix property/global
  const char* keyword;  // of pair_coeff
  const char *symbol, *unit;
  double physics::ContactParameters::*member;
  bool positive;  // 0 is an error where the law needs it
};

/// New constants go to the end: restart files of LAMMPS store the values in this order.
inline constexpr std::array<ConstantOfLaw, 5> constants_of_law = {
    {{"kn", "kn", "k_n", "", &physics::ContactParameters::normal_stiffness, true},
     {"gamman_abs", "gamman", "gamma_n", "kg/s", &physics::ContactParameters::normal_damping, false},
     {"kt", "kt", "k_t", "N/m", &physics::ContactParameters::tangential_stiffness, true},
     {"gammat_abs", "gammat", "gamma_t", "kg/s", &physics::ContactParameters::tangential_damping, false},
     {"coefficientFriction", "mu", "mu", "", &physics::ContactParameters::friction, false}}};

/// True if a law with these effects uses the constant.
bool is_needed(const ConstantOfLaw& constant, const physics::Effects& effects);
/// "" if it has none. That of k_n depends on the normal law.
std::string unit_of(const ConstantOfLaw& constant, physics::Normal normal);
/// Symbol and unit, for messages: "k_n [N/m]", "mu [-]".
std::string label_of(const ConstantOfLaw& constant, physics::Normal normal);

}  // namespace mikromakro::styles
