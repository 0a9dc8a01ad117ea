// SPDX-License-Identifier: GPL-2.0-or-later
// Friction between a disc and the bottom that it lies on (docs/conventions.md; the paper's cell has a
// bottom).
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/plane_vector.h"

namespace mikromakro::physics {

/// Force of the bottom on a disc that slides with the velocity v [N]: -F v/|v| with F = mu_b m g, regularised
/// at rest to -F v/v_0 below the velocity v_0 > 0 [m/s]. There is no torque: the force is the whole law.
inline PlaneVector bottom_friction(double sliding_force, PlaneVector v, double v_0) {
  const double scale = -sliding_force / std::max(std::sqrt(v.x * v.x + v.y * v.y), v_0);
  return {scale * v.x, scale * v.y};
}

/// Velocity that the bottom takes from a sliding disc in one step [m/s].
constexpr double velocity_lost_in_a_step(double mu_b, double g, double dt) {
  return mu_b * g * dt;
}

/// Least v_0 over the velocity lost in a step: with predicted velocities the regularised force overshoots
/// below 1, and does not settle; at 2 a disc comes to rest by a factor of 0.64 per step.
inline constexpr double least_regularisation = 2;

/// Chosen where the user chooses none: a tenth of the velocity below v_0 goes in each step, and v_0 is small
/// against every velocity that lasts longer than ten steps.
inline constexpr double default_regularisation = 10;

}  // namespace mikromakro::physics
