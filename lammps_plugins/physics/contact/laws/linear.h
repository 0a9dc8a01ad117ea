// SPDX-License-Identifier: GPL-2.0-or-later
// Linear normal spring (Latzel2001 2.2).
#pragma once

#include <algorithm>

#include "physics/contact/contact_duration.h"
#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

struct LinearNormal {
  static constexpr const char* name = "disc/linear";
  static constexpr const char* effect = "linear normal force";
  static constexpr const char* unit_of_stiffness = "N/m";
  static constexpr double exponent = 1.0;             // of the overlap
  static constexpr bool depends_on_radius = false;    // on ContactState::reduced_radius
  static constexpr bool depends_on_velocity = false;  // the duration of a contact

  /// k_n overlap [N].
  static double force(double k_n, const ContactState& s) { return k_n * s.overlap; }
  /// Integral of the force over the overlap [J].
  static double energy(double k_n, const ContactState& s) { return 0.5 * force(k_n, s) * s.overlap; }
  /// Slope of the force [N/m]; a_12 [m].
  static double stiffness(double k_n, double /*a_12*/, double /*overlap*/) { return k_n; }
  /// Duration of a contact [s], for the check of the time step; that of the tangential spring if it is
  /// stiffer.
  static double duration(const ContactParameters& p, const Collision& c) {
    const double normal = contact_duration(p.normal_stiffness, p.normal_damping, c.m12);
    const bool stiffer = p.tangential_stiffness > p.normal_stiffness;
    return stiffer ? std::min(normal, contact_duration(p.tangential_stiffness, 0, c.m12)) : normal;
  }
};

}  // namespace mikromakro::physics
