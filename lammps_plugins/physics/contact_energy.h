// SPDX-License-Identifier: GPL-2.0-or-later
// Energy that a contact stores (contact_law.h), and the power that it takes out of the motion.
#pragma once

#include "physics/contact_law.h"

namespace mikromakro::physics {

/// The integral of the elastic force over the overlap [J]: 1/2 of force times overlap, 2/5 for Hertz's law.
template <Effects effects>
double normal_energy(const ContactParameters& p, const ContactState& s) {
  return (effects.normal == Normal::hertz ? 0.4 : 0.5) * elastic_force<effects>(p, s) * s.overlap;
}

/// k_t xi^2 / 2 [J].
inline double spring_energy(const ContactParameters& p, double xi) {
  return p.tangential_stiffness * xi * xi / 2;
}

/// (f_n - elastic force) v_n [W]: what the normal dashpot turns into heat; less where attraction is cut off.
template <Effects effects>
double dashpot_power(const ContactParameters& p, const ContactState& s, double f_n) {
  return (f_n - elastic_force<effects>(p, s)) * s.v_n;
}

/// -f_t v_t [W]: what the tangential force takes out of the motion. What the springs do not store of it is
/// lost to sliding and tangential dashpots, and when contacts open with a stretched spring.
inline double tangential_power(double f_t, double v_t) {
  return -f_t * v_t;
}

}  // namespace mikromakro::physics
