// SPDX-License-Identifier: GPL-2.0-or-later
// The fastest rate at which the dashpots of given contacts slow discs down: with it, velocity Verlet has a
// largest stable time step (contact_duration.h).
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/contact/contact_state.h"

namespace mikromakro::physics {

/// A disc as its dashpots see it; both 0 for one whose motion is prescribed.
struct DampedDisc {
  double inverse_mass = 0, inverse_inertia = 0;  // [1/kg, 1/(kg m^2)]
};

struct DashpotContact {
  int i, j;                 // indices of discs; j < 0: something at rest
  bool acts_on_j;           // false if the contact is listed for j as well
  double n_x, n_y;          // from i to j
  double arm_i, arm_j;      // lever arms [m]
  double gamma_n, gamma_t;  // [kg/s]
};

/// Velocities and spins of discs, or forces and torques on them.
struct DampedMotion {
  double x = 0, y = 0, spin = 0;
};

/// Forces of the dashpots, D u for u = the motion.
inline std::vector<DampedMotion> dashpot_forces(const std::vector<DashpotContact>& contacts,
                                                const std::vector<DampedMotion>& motion) {
  std::vector<DampedMotion> forces(motion.size());
  for (const DashpotContact& c : contacts) {
    const DampedMotion& one = motion[c.i];
    const DampedMotion two = c.j < 0 ? DampedMotion{} : motion[c.j];
    const double x = one.x - two.x, y = one.y - two.y;
    const double f_n = c.gamma_n * (x * c.n_x + y * c.n_y);
    const double f_t = c.gamma_t * (-x * c.n_y + y * c.n_x + one.spin * c.arm_i + two.spin * c.arm_j);
    const double f_x = f_n * c.n_x - f_t * c.n_y, f_y = f_n * c.n_y + f_t * c.n_x;
    forces[c.i].x += f_x;
    forces[c.i].y += f_y;
    forces[c.i].spin += f_t * c.arm_i;
    if (c.j < 0 || !c.acts_on_j) continue;
    forces[c.j].x -= f_x;
    forces[c.j].y -= f_y;
    forces[c.j].spin += f_t * c.arm_j;
  }
  return forces;
}

/// No eigenvalue of M^-1 D is larger [1/s]: with (a + b)^2 <= 2 (a^2 + b^2) for what the two discs add to the
/// approach or the slip of a contact, and (v + arm w)^2 <= (1/m + arm^2/I) (m v^2 + I w^2) for each, u.D.u is
/// at most u.M.u times the largest sum, over the contacts of a disc, of 2 gamma_n/m + 2 gamma_t (1/m +
/// arm^2/I). Equal for a pair.
inline double bound_of_dashpot_rate(const std::vector<DashpotContact>& contacts,
                                    const std::vector<DampedDisc>& discs) {
  std::vector<double> sums(discs.size());
  const auto take = [&](int i, double arm, const DashpotContact& c) {
    sums[i] += 2 * (c.gamma_n * discs[i].inverse_mass +
                    c.gamma_t * (discs[i].inverse_mass + arm * arm * discs[i].inverse_inertia));
  };
  for (const DashpotContact& c : contacts) {
    take(c.i, c.arm_i, c);
    if (c.j >= 0 && c.acts_on_j) take(c.j, c.arm_j, c);
  }
  double largest = 0;
  for (const double sum : sums) largest = sum > largest ? sum : largest;
  return largest;
}

/// Largest eigenvalue of M^-1 D [1/s], by 40 steps of the power method from a fixed start: from below, the
/// error of the Rayleigh quotient u.D.u/u.M.u being that of the mode squared. 0 without dashpots.
inline double largest_dashpot_rate(const std::vector<DashpotContact>& contacts,
                                   const std::vector<DampedDisc>& discs) {
  std::vector<DampedMotion> motion(discs.size());
  std::uint32_t state = 1;
  const auto next = [&state] { return (state = 1664525u * state + 1013904223u) / 4294967296.0 - 0.5; };
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const DampedDisc& disc = discs[k];
    if (disc.inverse_mass > 0)
      motion[k] = {next(), next(), next() * std::sqrt(disc.inverse_inertia / disc.inverse_mass)};
  }
  double rate = 0;
  for (int step = 0; step < 40; ++step) {
    const std::vector<DampedMotion> forces = dashpot_forces(contacts, motion);
    double power = 0, momentum = 0;  // u.D.u, u.M.u
    for (std::size_t k = 0; k < discs.size(); ++k) {
      const DampedDisc& disc = discs[k];
      if (!(disc.inverse_mass > 0)) continue;
      DampedMotion& u = motion[k];
      power += u.x * forces[k].x + u.y * forces[k].y + u.spin * forces[k].spin;
      momentum += (u.x * u.x + u.y * u.y) / disc.inverse_mass + u.spin * u.spin / disc.inverse_inertia;
    }
    if (!(power > 0 && momentum > 0)) return rate;
    rate = power / momentum;
    for (std::size_t k = 0; k < discs.size(); ++k)
      motion[k] = {forces[k].x * discs[k].inverse_mass / rate, forces[k].y * discs[k].inverse_mass / rate,
                   forces[k].spin * discs[k].inverse_inertia / rate};
  }
  return rate;
}

}  // namespace mikromakro::physics
