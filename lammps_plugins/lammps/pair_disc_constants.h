// SPDX-License-Identifier: GPL-2.0-or-later
// Material constants in pair_coeff.
#pragma once

#include <array>

#include "physics/contact/contact_state.h"

namespace mikromakro::styles {

struct ConstantOfPair {
  const char *keyword, *symbol;
  const char* name;  // name in snapshots, the same for all engines
  double physics::ContactParameters::*member;
  bool positive;
};

// In the order of PairDisc::Coefficients.
inline constexpr std::array<ConstantOfPair, 5> constants_of_pair = {
    {{"kn", "k_n", "kn", &physics::ContactParameters::normal_stiffness, true},
     {"gamman", "gamma_n [kg/s]", "gamman_abs", &physics::ContactParameters::normal_damping, false},
     {"kt", "k_t [N/m]", "kt", &physics::ContactParameters::tangential_stiffness, true},
     {"gammat", "gamma_t [kg/s]", "gammat_abs", &physics::ContactParameters::tangential_damping, false},
     {"mu", "mu [-]", "coefficientFriction", &physics::ContactParameters::friction, false}}};

}  // namespace mikromakro::styles
