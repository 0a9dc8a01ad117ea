// SPDX-License-Identifier: GPL-2.0-or-later
// Servo-controlled wall with mass, driven by the discs and an external load: m x'' = F - gamma x', by
// velocity Verlet. F is evaluated at the time of the position and gamma x' is solved implicitly for the
// velocity at the same time, so the error is O(dt^2) for any gamma.
#pragma once

#include <cmath>
#include <numbers>

namespace mikromakro::physics {

struct ServoWall {
  double position = 0.0;      // x (m)
  double velocity = 0.0;      // x' (m/s)
  double acceleration = 0.0;  // x'' (m/s^2)
};

// First half of a step: advances the velocity to mid-step and the position to the end of the step.
inline ServoWall servo_drift(const ServoWall& wall, double dt) {
  const double half_step = wall.velocity + 0.5 * dt * wall.acceleration;
  return {wall.position + dt * half_step, half_step, wall.acceleration};
}

// End-of-step velocity predicted from the force at the beginning, for velocity-dependent contact forces. The
// error is O(dt^2), as for the velocities that fix nve/disc predicts for discs.
inline double predicted_velocity(const ServoWall& drifted, double dt) {
  return drifted.velocity + 0.5 * dt * drifted.acceleration;
}

struct ServoProperties {
  double mass;     // kg
  double damping;  // gamma (kg/s)
};

// Second half of a step, with the force (N) at its end.
inline ServoWall servo_kick(const ServoWall& drifted, double force, const ServoProperties& p, double dt) {
  const double velocity =
      (drifted.velocity + 0.5 * dt * force / p.mass) / (1 + 0.5 * dt * p.damping / p.mass);
  return {drifted.position, velocity, (force - p.damping * velocity) / p.mass};
}

// Half period (s) of a wall on contacts of total stiffness K (N/m) with immobile discs: pi sqrt(m/K), the
// shortest time scale of its motion for any damping. As with contacts (contact_duration.h), the time step
// should be a fiftieth of it.
inline double servo_half_period(double mass, double stiffness) {
  return std::numbers::pi * std::sqrt(mass / stiffness);
}

// Net outward force on a wall of length L under an external pressure p (N/m) and the discs' force F: F - p L.
inline double servo_force(double pressing, double pressure, double length) {
  return pressing - pressure * length;
}

}  // namespace mikromakro::physics
