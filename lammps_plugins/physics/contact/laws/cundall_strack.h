// SPDX-License-Identifier: GPL-2.0-or-later
// Cundall-Strack spring (Latzel2001 2.2, as specified in docs/conventions.md), alone or with a dashpot in
// parallel.
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

/// xi grows by the slip; the trial force -k_t xi [- gamma_t v_t] holds up to the cap mu |f_n|. Beyond it the
/// contact slides at the cap, and the spring is reset to carry the cap less the dashpot's part, never
/// stretched further than the cap allows.
///
/// A spring stretched to the cap, of a contact that slid while its slip turned round, forgets how much the
/// dashpot carried. Evaluated again without slip, as the set-up of a continued run does, such a contact is
/// still at the cap.
template <bool dashpot>
struct CundallStrack {
  static constexpr const char* name = "disc/cundall_strack";
  static constexpr const char* effect = "friction with spring";
  static constexpr bool has_spring = true, has_dashpot = dashpot;

  static ContactForce force(const ContactParameters& p, const ContactState& s, double f_n, double slip,
                            double compliance) {
    const double cap = p.friction * std::abs(f_n);
    const double viscous = dashpot ? p.tangential_damping * s.v_t : 0.0;
    const double stretched = s.xi + slip;
    const double elastic = -p.tangential_stiffness * stretched, trial = elastic - viscous;
    // Both outcomes are computed and one is selected: no branch, so that the loop over contacts vectorises.
    const bool sticks = std::abs(trial) <= cap;
    const bool stays_at_cap =
        dashpot && sticks && slip == 0 && std::abs(std::abs(elastic) - cap) <= rounding * cap;
    const double f_t = std::clamp(stays_at_cap ? elastic : trial, -cap, cap);
    const double sliding_xi = std::clamp(-(f_t + viscous), -cap, cap) * compliance;
    return {f_n, f_t, sticks ? stretched : sliding_xi};
  }

 private:
  static constexpr double rounding = 1e-12;
};

}  // namespace mikromakro::physics
