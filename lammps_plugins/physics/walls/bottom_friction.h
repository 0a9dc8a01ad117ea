// SPDX-License-Identifier: GPL-2.0-or-later
// Friction between a disc and the bottom plate it lies on (docs/conventions.md; the cell of Latzel2001 has
// such a plate).
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/math/plane_vector.h"

namespace mikromakro::physics {

/// Friction force of the bottom on a disc sliding with velocity v [N]: -F v/|v| with F = mu_b m g,
/// regularised to -F v/v_0 below the velocity v_0 > 0 [m/s]. No torque acts on the disc.
inline PlaneVector bottom_friction(double sliding_force, PlaneVector v, double v_0) {
  const double scale = -sliding_force / std::max(std::sqrt(v.x * v.x + v.y * v.y), v_0);
  return {scale * v.x, scale * v.y};
}

/// Velocity a sliding disc loses to bottom friction in one step [m/s].
constexpr double velocity_lost_in_a_step(double mu_b, double g, double dt) {
  return mu_b * g * dt;
}

/// Smallest allowed ratio of v_0 to the velocity lost per step. With predicted velocities, the regularised
/// force overshoots below 1 and the disc never settles; at 2 the velocity decays by a factor of 0.64 per
/// step.
inline constexpr double least_regularisation = 2;

/// Default ratio: below v_0 a disc loses a tenth of its velocity per step, and v_0 stays small compared with
/// any velocity that persists for more than ten steps.
inline constexpr double default_regularisation = 10;

}  // namespace mikromakro::physics
