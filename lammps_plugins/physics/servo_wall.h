// SPDX-License-Identifier: GPL-2.0-or-later
// A wall with a mass of its own that discs and an outer load push: m x'' = F - gamma x', by velocity Verlet.
// F is the force of the same instant as the position, gamma x' is solved for the velocity of that instant,
// too, so that the error is of order dt^2 whatever gamma is.
#pragma once

#include <cmath>
#include <numbers>

namespace mikromakro::physics {

struct ServoWall {
  double position = 0.0;      // x (m)
  double velocity = 0.0;      // x' (m/s)
  double acceleration = 0.0;  // x'' (m/s^2)
};

// First half of a step: the velocity of its middle and the position at its end.
inline ServoWall servo_drift(const ServoWall& wall, double dt) {
  const double half_step = wall.velocity + 0.5 * dt * wall.acceleration;
  return {wall.position + dt * half_step, half_step, wall.acceleration};
}

// The velocity at the end of the step as far as the force at its beginning tells, for contacts that depend on
// it; off by order dt^2, as fix nve/disc predicts those of discs.
inline double predicted_velocity(const ServoWall& drifted, double dt) {
  return drifted.velocity + 0.5 * dt * drifted.acceleration;
}

struct ServoProperties {
  double mass;     // kg
  double damping;  // gamma (kg/s)
};

// Second half, with the force (N) at the end of the step.
inline ServoWall servo_kick(const ServoWall& drifted, double force, const ServoProperties& p, double dt) {
  const double velocity =
      (drifted.velocity + 0.5 * dt * force / p.mass) / (1 + 0.5 * dt * p.damping / p.mass);
  return {drifted.position, velocity, (force - p.damping * velocity) / p.mass};
}

// Half a period (s) of a wall on contacts with discs that do not yield, of the summed stiffness K (N/m):
// pi sqrt(m/K), the shortest time in which it moves, whatever its damping. As contacts do
// (contact_duration.h), it asks for time steps of a fiftieth.
inline double servo_half_period(double mass, double stiffness) {
  return std::numbers::pi * std::sqrt(mass / stiffness);
}

// Force of an outer pressure p (N/m) on a wall of length L, beside the discs' F: F - p L, outwards.
inline double servo_force(double pressing, double pressure, double length) {
  return pressing - pressure * length;
}

}  // namespace mikromakro::physics
