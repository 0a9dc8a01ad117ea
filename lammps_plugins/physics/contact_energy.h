// Energy that a contact of the linear law (contact_law.h) stores, and the power that it takes out of the
// motion.
#pragma once

#include "physics/contact_law.h"

namespace mikromakro::physics {

/// k_n overlap^2 / 2 [J].
inline double normal_energy(const ContactParameters& p, double overlap) {
  return p.normal_stiffness * overlap * overlap / 2;
}

/// k_t xi^2 / 2 [J].
inline double spring_energy(const ContactParameters& p, double xi) {
  return p.tangential_stiffness * xi * xi / 2;
}

/// (f_n - k_n overlap) v_n [W]: what the normal dashpot turns into heat; less where attraction is cut off.
inline double dashpot_power(const ContactParameters& p, double overlap, double f_n, double v_n) {
  return (f_n - p.normal_stiffness * overlap) * v_n;
}

/// -f_t v_t [W]: what the tangential force takes out of the motion. What the springs do not store of it is
/// lost to sliding and tangential dashpots, and when contacts open with a stretched spring.
inline double tangential_power(double f_t, double v_t) {
  return -f_t * v_t;
}

}  // namespace mikromakro::physics
