// SPDX-License-Identifier: GPL-2.0-or-later
// Contact law of two discs (or a disc and a wall) as a pure function: parameters and state in, force and
// updated tangential displacement out. Shared by all engines, the walls and the tests.
//
// Conventions: the normal n points from particle 1 to particle 2, the tangent is t = (-n_y, n_x).
//   overlap  a_1 + a_2 - |r_1 - r_2|, > 0 in contact                                      [m]
//   v_n      rate of the overlap, (v_1 - v_2).n, > 0 on approach                           [m/s]
//   v_t      slip rate of 1 against 2, (v_1 - v_2).t + omega_1 c_1 + omega_2 c_2           [m/s]
//   xi       tangential spring: slip of 1 against 2 that is stored elastically             [m]
// with the lever arms c_i = a_i - overlap/2 to the contact point. Both v_t and xi keep their sign when the
// particles are swapped. The force on 1 is -f_n n + f_t t, on 2 its opposite; both get the torque c_i f_t.
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
  damped_spring     // Cundall-Strack spring with a dashpot in parallel
};

/// The effects that a scene simulates. Each combination is a separate template instance of law and loop, so
/// that unused effects cost nothing.
struct Effects {
  Tangential tangential = Tangential::none;
  bool no_attraction = false;  // normal force cut off at zero (limitForce)
  Normal normal = Normal::linear;
  bool normal_dashpot = true;

  static constexpr bool has_spring(Tangential t) {
    return t == Tangential::spring || t == Tangential::damped_spring;
  }
  constexpr bool spring() const { return has_spring(tangential); }
  constexpr bool operator==(const Effects&) const = default;
};

/// All combinations, numbered from 0; loops and walls are instantiated for each.
inline constexpr int effect_combinations = 32;
constexpr Effects effects_of_combination(int number) {
  return {static_cast<Tangential>(number & 3), (number & 4) != 0,
          (number & 8) != 0 ? Normal::hertz : Normal::linear, (number & 16) == 0};
}

/// Material constants for a pair of particle types.
struct ContactParameters {
  double normal_stiffness = 0;      // k_n [N/m]; Hertz: [N/m^2]
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
  double xi;       // [m], before this step's slip
  // a_1 a_2 / (a_1 + a_2) [m]: Hertz only; NaN by default so that an unset value reaches the force
  double reduced_radius = std::numeric_limits<double>::quiet_NaN();
};

struct ContactForce {
  double f_n;  // [N], > 0: repulsive
  double f_t;  // [N], on particle 1 along t
  double xi;   // [m], after this step's slip
};

/// a_1 a_2 / (a_1 + a_2) [m]; a_2 < 0 for a disc inside a circle of radius |a_2|; for a flat wall use a_1.
constexpr double reduced_radius(double a_1, double a_2) {
  return a_1 * a_2 / (a_1 + a_2);
}

/// Elastic part of the normal force: k_n overlap, or Hertz's k_n sqrt(a_12 overlap) overlap with the reduced
/// radius a_12 (Latzel2001 2.2: ~ overlap^(3/2), for spheres k_n = 4/3 E* with 1/E* the sum of (1 - nu^2)/E).
template <Effects effects>
double elastic_force(const ContactParameters& p, const ContactState& s) {
  if constexpr (effects.normal == Normal::linear) return p.normal_stiffness * s.overlap;
  // Odd in the overlap, so that lanes without contact do not take the root of a negative number.
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

/// Cundall-Strack spring (Latzel2001 2.2, as specified in docs/conventions.md): xi grows by the slip; the
/// trial force -k_t xi [- gamma_t v_t] holds up to the cap mu |f_n|. Beyond it the contact slides at the cap,
/// and the spring is reset to carry the cap less the dashpot's part, never stretched further than the cap
/// allows.
template <Effects effects>
ContactForce spring_force(const ContactParameters& p, const ContactState& s, double f_n, double slip,
                          double compliance) {
  const double cap = p.friction * std::abs(f_n);
  const double viscous = effects.tangential == Tangential::damped_spring ? p.tangential_damping * s.v_t : 0.0;
  const double stretched = s.xi + slip;
  const double trial = -p.tangential_stiffness * stretched - viscous;
  const double f_t = std::clamp(trial, -cap, cap);
  // Both outcomes are computed and one is selected: no branch, so that the loop over contacts vectorises.
  const double sliding_xi = std::clamp(-(f_t + viscous), -cap, cap) * compliance;
  return {f_n, f_t, std::abs(trial) <= cap ? stretched : sliding_xi};
}

/// Force of one contact. slip [m]: displacement of 1 against 2 along t in this step, added to the spring
/// first; 0 evaluates the force at an unchanged spring. compliance: 1/k_t [m/N], passed in so that loops
/// divide once rather than per contact.
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

/// Effective overlap rate of the dashpot over a whole step [m/s]: v_n weighted by the number of steps that
/// the present force stands for. With s = overlap / |v_n| dt, the number of steps since contact onset or
/// until release, the weight is 3/2 s up to s = 1, then 2 - s/2, and 1 from s = 2 on. The weight is
/// continuous and sums to the contact duration, wherever within a step the contact begins and ends.
/// `frequency` = 1/dt; infinity leaves v_n unchanged.
inline double rate_of_step(const ContactState& s, double frequency) {
  const double speed = std::abs(s.v_n), overlap_per_step = s.overlap * frequency;
  const double shared = std::min(1.5 * overlap_per_step, std::max(speed, 2 * speed - overlap_per_step / 2));
  return std::copysign(shared, s.v_n);
}

/// The `frequency` for force_of_step() [1/s]. Infinite for mid-step velocities, which the stock integrators
/// supply: they get no weighting.
inline double frequency_of_steps(bool predicted, double dt) {
  return predicted ? 1 / dt : std::numeric_limits<double>::infinity();
}

/// Force averaged over the step, from the instantaneous force `now`: the dashpot force, which jumps at
/// contact onset and release, is weighted by the fraction of the step in contact, and friction scales with
/// f_n. In the middle of a contact, and without a dashpot, the result equals the instantaneous force bit for
/// bit. Only the accuracy measurements use it (impact.h); fix nve/disc uses the instantaneous force, for the
/// reason given in docs/results/accuracy.md.
template <Effects effects>
ContactForce force_of_step(const ContactParameters& p, const ContactState& s, const ContactForce& now,
                           double frequency) {
  if constexpr (!effects.normal_dashpot) return now;
  ContactState shared = s;
  shared.v_n = rate_of_step(s, frequency);
  const double f_n = normal_force<effects>(p, shared);
  if constexpr (effects.tangential == Tangential::none) return {f_n, 0.0, 0.0};
  // f_t vanishes where f_n does.
  const double part = std::abs(f_n) / std::max(std::abs(now.f_n), std::numeric_limits<double>::min());
  return {f_n, now.f_t * part, now.xi};
}

}  // namespace mikromakro::physics
