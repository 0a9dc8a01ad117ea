// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/material_constants.h"

namespace mikromakro::styles {

using P = physics::ContactParameters;

bool is_needed(const ConstantOfLaw& constant, const physics::Effects& effects) {
  if (constant.member == &P::normal_damping) return effects.normal_dashpot;
  if (constant.member == &P::friction) return effects.tangential != physics::Tangential::none;
  if (constant.member == &P::tangential_stiffness) return physics::has_spring(effects.tangential);
  if (constant.member == &P::tangential_damping) return physics::has_dashpot(effects.tangential);
  return true;
}

std::string unit_of(const ConstantOfLaw& constant, physics::Normal normal) {
  if (constant.member != &P::normal_stiffness) return constant.unit;
  return physics::with_law(normal, [](auto law) { return law.unit_of_stiffness; });
}

std::string label_of(const ConstantOfLaw& constant, physics::Normal normal) {
  const std::string unit = unit_of(constant, normal);
  return std::string(constant.symbol) + " [" + (unit.empty() ? "-" : unit) + "]";
}

}  // namespace mikromakro::styles
