// SPDX-License-Identifier: GPL-2.0-or-later
// Viscous tangential force below the Coulomb limit, Latzel2001 Eq. 1.
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

struct ViscousCoulomb {
  static constexpr const char* name = "disc/viscous";
  static constexpr const char* effect = "friction by Eq. 1";
  static constexpr bool has_spring = false, has_dashpot = true;

  /// f_t = -min(gamma_t |v_t|, mu |f_n|) sign(v_t).
  static ContactForce force(const ContactParameters& p, const ContactState& s, double f_n, double /*slip*/,
                            double /*compliance*/) {
    const double cap = p.friction * std::abs(f_n);
    return {f_n, std::clamp(-p.tangential_damping * s.v_t, -cap, cap), 0.0};
  }
};

}  // namespace mikromakro::physics
