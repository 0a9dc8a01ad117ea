// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic energy stored in a contact (contact_law.h), and power that the contact extracts from the motion.
#pragma once

#include "physics/contact/contact_law.h"

namespace mikromakro::physics {

/// Elastic energy of the normal spring [J], the integral of the elastic force over the overlap.
template <Effects effects>
double normal_energy(const ContactParameters& p, const ContactState& s) {
  return NormalLaw<effects.normal>::energy(p.normal_stiffness, s);
}

/// Elastic energy of the tangential spring, k_t xi^2 / 2 [J].
inline double spring_energy(const ContactParameters& p, double xi) {
  return p.tangential_stiffness * xi * xi / 2;
}

/// (f_n - elastic force) v_n [W]: power dissipated by the normal dashpot; reduced where attraction is cut
/// off.
template <Effects effects>
double dashpot_power(const ContactParameters& p, const ContactState& s, double f_n) {
  return (f_n - elastic_force<effects>(p, s)) * s.v_n;
}

/// -f_t v_t [W]: power that the tangential force extracts from the motion. The part not stored in springs is
/// dissipated by sliding, by tangential dashpots, and when a contact opens with a stretched spring.
inline double tangential_power(double f_t, double v_t) {
  return -f_t * v_t;
}

}  // namespace mikromakro::physics
