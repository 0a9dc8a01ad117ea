// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/material_constants.h"

namespace mikromakro::styles {

bool is_needed(double physics::ContactParameters::*constant, const physics::Effects& effects) {
  using P = physics::ContactParameters;
  if (constant == &P::normal_damping) return effects.normal_dashpot;
  if (constant == &P::friction) return effects.tangential != physics::Tangential::none;
  if (constant == &P::tangential_stiffness) return physics::has_spring(effects.tangential);
  if (constant == &P::tangential_damping) return physics::has_dashpot(effects.tangential);
  return true;
}

}  // namespace mikromakro::styles
