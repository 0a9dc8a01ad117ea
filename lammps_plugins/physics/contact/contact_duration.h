// SPDX-License-Identifier: GPL-2.0-or-later
// Duration and restitution of a head-on collision under the linear spring-dashpot law (Latzel2001 2.2 and
// 2.3), and duration of an elastic collision under Hertz's law.
#pragma once

#include <cmath>
#include <numbers>

namespace mikromakro::physics {

/// Reduced mass m12 = m_1 m_2 / (m_1 + m_2) [kg].
inline double reduced_mass(double m_1, double m_2) {
  return m_1 * m_2 / (m_1 + m_2);
}

/// Contact duration t_c = pi / sqrt(k_n/m12 - (gamma_n / 2 m12)^2) [s]. An overdamped contact never
/// separates; the undamped duration pi / sqrt(k_n/m12) is then returned, as the time scale that limits the
/// time step.
inline double contact_duration(double k_n, double gamma_n, double m12) {
  const double eta = gamma_n / (2 * m12);
  const double omega_squared = k_n / m12 - eta * eta;
  return std::numbers::pi / std::sqrt(omega_squared > 0 ? omega_squared : k_n / m12);
}

/// Coefficient of restitution e_n = exp(-gamma_n t_c / 2 m12), provided that the normal force may become
/// attractive at the end of the contact.
inline double restitution(double k_n, double gamma_n, double m12) {
  return std::exp(-gamma_n * contact_duration(k_n, gamma_n, m12) / (2 * m12));
}

/// gamma_n [kg/s] for a given restitution e_n, 0 < e_n <= 1: with l = -ln e_n, gamma_n/2 m12 = sqrt(k_n/m12)
/// l / sqrt(pi^2 + l^2).
inline double damping_of_restitution(double k_n, double e_n, double m12) {
  const double l = -std::log(e_n);
  return 2 * std::sqrt(k_n * m12) * l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
}

/// k_H [N/m^(3/2)] of f_n = k_H overlap^(3/2), the Hertz law of contact_law.h for a given pair: k_H = k_n
/// sqrt(a_12).
inline double hertz_stiffness(double k_n, double reduced_radius) {
  return k_n * std::sqrt(reduced_radius);
}

/// Maximum overlap [m] in an elastic impact at v [m/s], from m12 v^2 / 2 = 2/5 k_H overlap^(5/2).
inline double hertz_largest_overlap(double k_h, double m12, double v) {
  return std::pow(5 * m12 * v * v / (4 * k_h), 0.4);
}

/// Duration of an elastic impact at v [s]: t_c = 2 int_0^d dx / sqrt(v^2 - 4/5 k_H/m12 x^(5/2)) with the
/// maximum overlap d, i.e. (4/5) B(2/5, 1/2) d/v = 3.2181 (m12^2 / (k_H^2 v))^(1/5). Infinite for v = 0.
inline double hertz_contact_duration(double k_h, double m12, double v) {
  // B(2/5, 1/2) = Gamma(2/5) Gamma(1/2) / Gamma(9/10); d/v = (5/4)^(2/5) (m12^2 / (k_H^2 v))^(1/5).
  static const double factor =
      0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * std::pow(1.25, 0.4);
  return factor * std::pow(m12 * m12 / (k_h * k_h * v), 0.2);
}

/// Tangent stiffness of Hertz's law at a given overlap [N/m]: 3/2 k_H sqrt(overlap).
inline double hertz_tangent_stiffness(double k_h, double overlap) {
  return 1.5 * k_h * std::sqrt(overlap);
}

/// Recommended minimum number of steps per contact (Latzel2001 2.3).
inline constexpr double steps_per_contact = 50;

/// Fewer steps per contact are rejected. Velocity Verlet of a single undamped contact is unstable below
/// t_c/dt = pi/2. The stiffest mode of a triangular packing has three times the squared frequency of a pair,
/// which requires 2.7; frictional springs with k_t up to k_n require about 4.
inline constexpr double least_steps_per_contact = 4;

/// Rates at which dashpots slow a pair down: its approach, and its slip with the mass m12/3 [1/s]. In a
/// triangular lattice the stiffest modes have three and four times these rates: neighbouring rows that move
/// against each other, 3 gamma_n/m12, and discs that all spin alike, 12 gamma_t/m12. For other contacts see
/// dashpot_rate.h.
inline double normal_dashpot_rate(double gamma_n, double m12) {
  return gamma_n / m12;
}
inline double tangential_dashpot_rate(double gamma_t, double m12) {
  return 3 * gamma_t / m12;
}
inline constexpr double normal_rate_of_lattice = 3, tangential_rate_of_lattice = 4;

/// Largest stable time step [s] of velocity Verlet for a mode that dashpots slow down at `rate`. With
/// velocities half a step earlier than the positions, z = 1 - rate dt, stable to 2/rate. Predicted velocities
/// contain half of the previous step's force as well: z^2 - (1 - 3/2 rate dt) z - rate dt/2 = 0, to 1/rate.
/// Springs with w = omega^2 dt^2 in the same mode reduce both by the factor 1 - w/4.
inline double stable_dashpot_step(double rate, bool predicted) {
  return (predicted ? 1 : 2) / rate;
}

}  // namespace mikromakro::physics
