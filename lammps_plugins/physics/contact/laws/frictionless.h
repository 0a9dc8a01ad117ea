// SPDX-License-Identifier: GPL-2.0-or-later
// No tangential force.
#pragma once

#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

struct Frictionless {
  static constexpr const char* name = "off";
  static constexpr const char* effect = "friction";  // the one that is missing
  static constexpr bool has_spring = false, has_dashpot = false;

  static ContactForce force(const ContactParameters& /*p*/, const ContactState& /*s*/, double f_n,
                            double /*slip*/, double /*compliance*/) {
    return {f_n, 0.0, 0.0};
  }
};

}  // namespace mikromakro::physics
