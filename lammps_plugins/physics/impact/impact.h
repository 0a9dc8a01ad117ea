// SPDX-License-Identifier: GPL-2.0-or-later
// Impact of two equal discs, and its time-step error averaged over the phases of contact onset and release
// within a step.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "physics/impact/free_pair.h"

namespace mikromakro::physics {

struct Impact {
  ContactParameters law;
  double radius, mass;  // of each disc [m, kg]
  double v_n, v_t;      // approach and slip velocity before the impact [m/s]
  double duration;      // reference duration for counting time steps [s]
};

/// v_n'/v_n, v_t'/v_n, contact duration / Impact::duration, kinetic energy after / before.
enum Quantity { restitution_of_impact, slip_after, duration_of_impact, energy_left, impact_quantities };
using Rebound = std::array<double, impact_quantities>;

/// Simulates one impact whose contact begins `onset` steps after the start, with `steps` time steps per
/// Impact::duration. Returns NaN if the contact has not ended after 20 durations.
template <Effects effects>
Rebound rebound(const Impact& impact, double steps, double onset, Scheme scheme) {
  const double dt = impact.duration / steps, apart = 2 * impact.radius + onset * dt * impact.v_n;
  using Pair = FreePair<effects>;
  const typename Pair::Disc one{{{0, 0}, {impact.v_n / 2, impact.v_t / 2}, 0, impact.radius}, impact.mass},
      two{{{apart, 0}, {-impact.v_n / 2, -impact.v_t / 2}, 0, impact.radius}, impact.mass};
  Pair pair(impact.law, {one, two}, dt, scheme);
  const double before = pair.kinetic_energy();
  bool met = false;
  for (int k = 1; k < 20 * steps; ++k) {
    pair.step();
    const auto state = pair.state();
    met = met || state.overlap > 0;
    if (!met || state.overlap > 0) continue;
    const double parted = k * dt - state.overlap / state.v_n;
    return {-state.v_n / impact.v_n, state.v_t / impact.v_n, (parted - onset * dt) / impact.duration,
            pair.kinetic_energy() / before};
  }
  Rebound none;
  none.fill(std::numeric_limits<double>::quiet_NaN());
  return none;
}

/// Reference solution with a time step so small that its error (second order) is below 1e-7.
template <Effects effects>
Rebound exact_rebound(const Impact& impact) {
  constexpr int phases = 4, steps = 20000;
  Rebound mean{};
  for (int k = 0; k < phases; ++k) {
    const auto one = rebound<effects>(impact, steps + k / 4.0, (k + 0.5) / phases, Scheme::share_of_step);
    for (int q = 0; q < impact_quantities; ++q) mean[q] += one[q] / phases;
  }
  return mean;
}

struct ImpactError {
  Rebound mean{}, rms{};
};

/// Mean and rms error over the phases of onset and release. Both are varied because the errors cancel if the
/// contact lasts a whole number of steps.
template <Effects effects>
ImpactError error_over_phases(const Impact& impact, double steps, Scheme scheme, const Rebound& exact) {
  constexpr int phases = 8, trials = phases * phases;
  ImpactError error;
  for (int onset = 0; onset < phases; ++onset) {
    for (int release = 0; release < phases; ++release) {
      const auto one = rebound<effects>(impact, steps + static_cast<double>(release) / phases,
                                        (onset + 0.5) / phases, scheme);
      for (int q = 0; q < impact_quantities; ++q) {
        error.mean[q] += (one[q] - exact[q]) / trials;
        error.rms[q] += (one[q] - exact[q]) * (one[q] - exact[q]) / trials;
      }
    }
  }
  for (double& square : error.rms) square = std::sqrt(square);
  return error;
}

/// Rms error, over the phases, of the relative velocity at the contact point after the impact, divided by its
/// value before.
inline double error_of_velocity(const Impact& impact, const ImpactError& error) {
  const double before = std::hypot(1, impact.v_t / impact.v_n);
  return std::hypot(error.rms[restitution_of_impact], error.rms[slip_after]) / before;
}

/// Fewest steps of fix nve/disc per Impact::duration, within 2 %, for which error_of_velocity() is at most
/// `wanted`. NaN if the maximum number tried does not suffice or the contact does not end.
template <Effects effects>
double steps_for_error(const Impact& impact, double wanted) {
  constexpr double least = 5, most = 4000;
  const auto exact = exact_rebound<effects>(impact);
  const auto suffice = [&](double steps) {
    const auto error = error_over_phases<effects>(impact, steps, Scheme::same_instant, exact);
    return error_of_velocity(impact, error) <= wanted;
  };
  if (!suffice(most)) return std::numeric_limits<double>::quiet_NaN();
  double steps = most;
  for (const double ratio : {1.25, 1.02}) {
    while (steps / ratio > least && suffice(steps / ratio)) steps /= ratio;
  }
  return steps;
}

}  // namespace mikromakro::physics
