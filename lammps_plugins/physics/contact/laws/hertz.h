// SPDX-License-Identifier: GPL-2.0-or-later
// Normal force of Hertz: spheres (Latzel2001 2.2: ~ overlap^(3/2)).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/contact_duration.h"
#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

/// k_n sqrt(a_12 overlap) overlap with the reduced radius a_12; for spheres k_n = 4/3 E* with 1/E* the sum of
/// (1 - nu^2)/E.
struct HertzNormal {
  static constexpr const char* name = "disc/hertz";
  static constexpr const char* effect = "normal force of Hertz";
  static constexpr const char* unit_of_stiffness = "N/m^2";
  static constexpr double exponent = 1.5;  // of the overlap
  static constexpr bool depends_on_radius = true;
  static constexpr bool depends_on_velocity = true;

  /// Odd in the overlap, so that lanes without contact do not take the root of a negative number.
  static double force(double k_n, const ContactState& s) {
    return k_n * std::sqrt(s.reduced_radius * std::abs(s.overlap)) * s.overlap;
  }
  static double energy(double k_n, const ContactState& s) { return 0.4 * force(k_n, s) * s.overlap; }
  static double stiffness(double k_n, double a_12, double overlap) {
    return hertz_tangent_stiffness(hertz_stiffness(k_n, a_12), overlap);
  }
  /// Of the collision, or of an oscillation about the largest overlap that is there, which is stiffer.
  static double duration(const ContactParameters& p, const Collision& c) {
    const double k_h = hertz_stiffness(p.normal_stiffness, c.reduced_radius);
    const double stiffest = std::max(hertz_tangent_stiffness(k_h, c.overlap), p.tangential_stiffness);
    const double oscillation =
        stiffest > 0 ? contact_duration(stiffest, 0, c.m12) : std::numeric_limits<double>::infinity();
    return std::min(hertz_contact_duration(k_h, c.m12, c.velocity), oscillation);
  }
};

}  // namespace mikromakro::physics
