// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law of two discs (or of a disc and a wall) as one pure function: parameters and state in, force
// and new spring out. Used by every engine, by walls and by the tests.
//
// Conventions: the normal n points from particle 1 to particle 2, the tangent is t = (-n_y, n_x).
//   overlap  a_1 + a_2 - |r_1 - r_2|, > 0 in contact                                      [m]
//   v_n      rate of the overlap, (v_1 - v_2).n, > 0 on approach                           [m/s]
//   v_t      slip rate of 1 against 2, (v_1 - v_2).t + omega_1 c_1 + omega_2 c_2           [m/s]
//   xi       tangential spring: slip of 1 against 2 that is stored elastically             [m]
// with the lever arms c_i = a_i - overlap/2 to the contact point. Both v_t and xi keep their sign when the
// particles change places. The force on 1 is -f_n n + f_t t, on 2 its opposite; both get the torque c_i f_t.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace mikromakro::physics {

enum class Normal {
  linear,  // spring of constant stiffness
  hertz    // spheres
};

enum class Tangential {
  none,             // no tangential force
  viscous_coulomb,  // Latzel2001 Eq. 1
  spring,           // Cundall-Strack spring
  damped_spring     // Cundall-Strack spring with a dashpot beside it
};

/// What a scene simulates; each value is its own compiled instance of law and loop.
struct Effects {
  Tangential tangential = Tangential::none;
  bool no_attraction = false;  // the normal force is cut off at zero (limitForce)
  Normal normal = Normal::linear;
  bool normal_dashpot = true;

  static constexpr bool has_spring(Tangential t) {
    return t == Tangential::spring || t == Tangential::damped_spring;
  }
  constexpr bool spring() const { return has_spring(tangential); }
  constexpr bool operator==(const Effects&) const = default;
};

/// All combinations, numbered from 0, from which loops and walls instantiate theirs.
inline constexpr int effect_combinations = 32;
constexpr Effects effects_of_combination(int number) {
  return {static_cast<Tangential>(number & 3), (number & 4) != 0,
          (number & 8) != 0 ? Normal::hertz : Normal::linear, (number & 16) == 0};
}

/// Material constants of a pair of types.
struct ContactParameters {
  double normal_stiffness = 0;      // k_n [N/m], of Hertz's law [N/m^2]
  double normal_damping = 0;        // gamma_n [kg/s]
  double tangential_stiffness = 0;  // k_t [N/m]
  double tangential_damping = 0;    // gamma_t [kg/s]
  double friction = 0;              // mu [-]

  constexpr bool operator==(const ContactParameters&) const = default;
};

struct ContactState {
  double overlap;  // [m]
  double v_n;      // [m/s]
  double v_t;      // [m/s]
  double xi;       // [m], before the slip
  // a_1 a_2 / (a_1 + a_2) [m]: for Hertz's law only, where a forgotten one shows in the force
  double reduced_radius = std::numeric_limits<double>::quiet_NaN();
};

struct ContactForce {
  double f_n;  // [N], > 0 repels
  double f_t;  // [N], on particle 1 along t
  double xi;   // [m], after the slip
};

/// a_1 a_2 / (a_1 + a_2) [m]; a_2 < 0 is the radius of an arc from inside, a flat wall gives a_1 itself.
constexpr double reduced_radius(double a_1, double a_2) {
  return a_1 * a_2 / (a_1 + a_2);
}

/// Elastic part of the normal force: k_n overlap, or Hertz's k_n sqrt(a_12 overlap) overlap with the reduced
/// radius a_12 (Latzel2001 2.2: ~ overlap^(3/2), for spheres k_n = 4/3 E* with 1/E* the sum of (1 - nu^2)/E).
template <Effects effects>
double elastic_force(const ContactParameters& p, const ContactState& s) {
  if constexpr (effects.normal == Normal::linear) return p.normal_stiffness * s.overlap;
  // Odd in the overlap, so that no lane of a batch takes the root of a negative number.
  return p.normal_stiffness * std::sqrt(s.reduced_radius * std::abs(s.overlap)) * s.overlap;
}

/// Normal force f_n = elastic force [+ gamma_n v_n] (Latzel2001 2.2; with delta = -overlap), optionally
/// without attraction.
template <Effects effects>
double normal_force(const ContactParameters& p, const ContactState& s) {
  double f_n = elastic_force<effects>(p, s);
  if constexpr (effects.normal_dashpot) f_n += p.normal_damping * s.v_n;
  return effects.no_attraction ? std::max(f_n, 0.0) : f_n;
}

/// Viscous force limited by Coulomb friction, Latzel2001 Eq. 1: f_t = -min(gamma_t |v_t|, mu |f_n|)
/// sign(v_t).
inline double viscous_coulomb_force(const ContactParameters& p, double v_t, double f_n) {
  const double cap = p.friction * std::abs(f_n);
  return std::clamp(-p.tangential_damping * v_t, -cap, cap);
}

/// Cundall-Strack spring (Latzel2001 2.2, as pinned in docs/conventions.md): xi grows by the slip; the trial
/// force -k_t xi [- gamma_t v_t] holds up to mu |f_n|; beyond it the force slides at the cap and the spring
/// is set to what the cap leaves for it, never longer than the cap allows.
template <Effects effects>
ContactForce spring_force(const ContactParameters& p, const ContactState& s, double f_n, double slip,
                          double compliance) {
  const double cap = p.friction * std::abs(f_n);
  const double viscous = effects.tangential == Tangential::damped_spring ? p.tangential_damping * s.v_t : 0.0;
  const double stretched = s.xi + slip;
  const double trial = -p.tangential_stiffness * stretched - viscous;
  const double f_t = std::clamp(trial, -cap, cap);
  // Both outcomes are worked out and one is chosen, which lets several contacts be evaluated side by side.
  const double sliding_xi = std::clamp(-(f_t + viscous), -cap, cap) * compliance;
  return {f_n, f_t, std::abs(trial) <= cap ? stretched : sliding_xi};
}

/// Force of one contact. slip [m] of 1 against 2 along t is what stretches the spring before; 0 evaluates the
/// force without moving it. compliance 1/k_t [m/N]: a loop divides once, not for each contact.
template <Effects effects>
ContactForce contact_force(const ContactParameters& p, const ContactState& s, double slip,
                           double compliance) {
  const double f_n = normal_force<effects>(p, s);
  if constexpr (effects.spring()) return spring_force<effects>(p, s, f_n, slip, compliance);
  if constexpr (effects.tangential == Tangential::viscous_coulomb) {
    return {f_n, viscous_coulomb_force(p, s.v_t, f_n), 0.0};
  }
  return {f_n, 0.0, 0.0};
}

template <Effects effects>
ContactForce contact_force(const ContactParameters& p, const ContactState& s, double slip) {
  return contact_force<effects>(p, s, slip, 1 / p.tangential_stiffness);
}

/// Rate of the overlap that the dashpot sees for a whole step [m/s]: v_n times the steps for which the force
/// that is evaluated now stands. With s = overlap / |v_n| dt, the steps since the discs met or until they
/// part, these are 3/2 s up to s = 1, then 2 - s/2, and 1 from s = 2 on: over a contact they sum up to its
/// duration, wherever in a step it begins and ends, and none of them jumps. `frequency` = 1/dt; infinite
/// leaves v_n.
inline double rate_of_step(const ContactState& s, double frequency) {
  const double speed = std::abs(s.v_n), overlap_per_step = s.overlap * frequency;
  const double shared = std::min(1.5 * overlap_per_step, std::max(speed, 2 * speed - overlap_per_step / 2));
  return std::copysign(shared, s.v_n);
}

/// For force_of_step() [1/s]; velocities of the middle of a step, as the stock integrators leave them, have
/// no share of it.
inline double frequency_of_steps(bool predicted, double dt) {
  return predicted ? 1 / dt : std::numeric_limits<double>::infinity();
}

/// What the force of an instant is for the step around it: the dashpot's force, which jumps when discs meet
/// and part, counts for the share of the step in contact, and friction changes in proportion to f_n. In the
/// middle of a contact, and without dashpot, it is the force of the instant, bit for bit. A scheme that is
/// measured (impact.h); fix nve/disc takes the force of the instant (docs/results/accuracy.md tells why).
template <Effects effects>
ContactForce force_of_step(const ContactParameters& p, const ContactState& s, const ContactForce& now,
                           double frequency) {
  if constexpr (!effects.normal_dashpot) return now;
  ContactState shared = s;
  shared.v_n = rate_of_step(s, frequency);
  const double f_n = normal_force<effects>(p, shared);
  if constexpr (effects.tangential == Tangential::none) return {f_n, 0.0, 0.0};
  // Where f_n is zero, so is f_t.
  const double part = std::abs(f_n) / std::max(std::abs(now.f_n), std::numeric_limits<double>::min());
  return {f_n, now.f_t * part, now.xi};
}

}  // namespace mikromakro::physics
