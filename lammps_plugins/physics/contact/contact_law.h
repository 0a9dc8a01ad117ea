// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law of two discs (or a disc and a wall) as a pure function of a combination of effects:
// parameters and state in, force and updated tangential displacement out (contact_state.h). Shared by all
// engines, the walls and the tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contact/contact_state.h"
#include "physics/contact/law_table.h"

namespace mikromakro::physics {

/// The effects that a scene simulates. Each combination is a separate template instance of law and loop, so
/// that unused effects cost nothing.
struct Effects {
  Tangential tangential = Tangential::none;
  bool no_attraction = false;  // normal force cut off at zero (limitForce)
  Normal normal = Normal::linear;
  bool normal_dashpot = true;

  constexpr bool spring() const { return has_spring(tangential); }
  constexpr bool operator==(const Effects&) const = default;
};

/// All combinations, numbered from 0; loops and walls are instantiated for each.
inline constexpr int effect_combinations = static_cast<int>(4 * tangential_laws * normal_laws);
constexpr Effects effects_of_combination(int number) {
  constexpr int tangential = static_cast<int>(tangential_laws);
  const int others = number / tangential;
  return {static_cast<Tangential>(number % tangential), (others & 1) != 0, static_cast<Normal>(others / 4),
          (others & 2) == 0};
}

/// Elastic part of the normal force [N].
template <Effects effects>
double elastic_force(const ContactParameters& p, const ContactState& s) {
  return NormalLaw<effects.normal>::force(p.normal_stiffness, s);
}

/// Normal force f_n = elastic force [+ gamma_n v_n] (Latzel2001 2.2; with delta = -overlap), optionally
/// without attraction.
template <Effects effects>
double normal_force(const ContactParameters& p, const ContactState& s) {
  double f_n = elastic_force<effects>(p, s);
  if constexpr (effects.normal_dashpot) f_n += p.normal_damping * s.v_n;
  return effects.no_attraction ? std::max(f_n, 0.0) : f_n;
}

/// Force of one contact. slip [m]: displacement of 1 against 2 along t in this step, added to the spring
/// first; 0 evaluates the force at an unchanged spring. compliance: 1/k_t [m/N], passed in so that loops
/// divide once rather than per contact.
template <Effects effects>
ContactForce contact_force(const ContactParameters& p, const ContactState& s, double slip,
                           double compliance) {
  return TangentialLaw<effects.tangential>::force(p, s, normal_force<effects>(p, s), slip, compliance);
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
