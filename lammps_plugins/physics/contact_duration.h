// Duration and restitution of a head-on collision under the linear spring-dashpot law (seed 2.2 and 2.3).
#pragma once

#include <cmath>
#include <numbers>

namespace mikromakro::physics {

/// Reduced mass m12 = m_1 m_2 / (m_1 + m_2) [kg].
inline double reduced_mass(double m_1, double m_2) {
  return m_1 * m_2 / (m_1 + m_2);
}

/// Contact duration t_c = pi / sqrt(k_n/m12 - (gamma_n / 2 m12)^2) [s]. An overdamped contact never
/// separates; its undamped duration pi / sqrt(k_n/m12) is returned then, the time scale that limits the step.
inline double contact_duration(double k_n, double gamma_n, double m12) {
  const double eta = gamma_n / (2 * m12);
  const double omega_squared = k_n / m12 - eta * eta;
  return std::numbers::pi / std::sqrt(omega_squared > 0 ? omega_squared : k_n / m12);
}

/// Coefficient of restitution e_n = exp(-gamma_n t_c / 2 m12), for a force that may attract at the end of the
/// contact.
inline double restitution(double k_n, double gamma_n, double m12) {
  return std::exp(-gamma_n * contact_duration(k_n, gamma_n, m12) / (2 * m12));
}

/// The rule of the seed (2.3): at least this many steps per contact.
inline constexpr double steps_per_contact = 50;

/// Below this many steps per contact the integration is refused. Velocity Verlet of one undamped contact is
/// unstable below t_c/dt = pi/2; in a triangular packing the stiffest mode has three times the squared
/// frequency of a pair, which asks for 2.7, and frictional springs with k_t up to k_n for about 4.
inline constexpr double least_steps_per_contact = 4;

}  // namespace mikromakro::physics
