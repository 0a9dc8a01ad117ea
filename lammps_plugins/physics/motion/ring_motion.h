// SPDX-License-Identifier: GPL-2.0-or-later
// Prescribed motion of a ring of wall discs: rotation at a constant rate about a fixed centre, with a radius
// that may change smoothly between two values.
//
// The position of a wall disc is a function of time only, x(t) = c + R(t) Q(theta(t)) u, with u the unit
// vector of its reference angle and Q the rotation by theta(t) = theta_0 + omega t, so no rounding error
// accumulates.
#pragma once

#include <cmath>

#include "physics/math/half_cosine.h"
#include "physics/math/plane_vector.h"

namespace mikromakro::physics {

// Radius as a function of time (m).
struct RadiusCourse : HalfCosine {
  [[nodiscard]] double radius(double time) const { return value(time); }
  [[nodiscard]] bool is_over(double time) const { return time >= duration; }
};

// State of a ring at one time, computed once per step and used for all its discs.
struct RingState {
  double angle = 0.0;   // theta (rad)
  double cosine = 1.0;  // of theta
  double sine = 0.0;
  double rotation_rate = 0.0;    // omega (1/s), counter-clockwise positive
  double radius = 0.0;           // R (m)
  double radial_velocity = 0.0;  // dR/dt (m/s)
};

struct RingMotion {
  RadiusCourse course;
  double rotation_rate = 0.0;  // omega (1/s)
  double angle_offset = 0.0;   // theta_0 (rad)

  [[nodiscard]] RingState at(double time) const {
    const double angle = angle_offset + rotation_rate * time;
    return {angle, std::cos(angle), std::sin(angle), rotation_rate, course.radius(time), course.rate(time)};
  }
};

struct WallDiscState {
  PlaneVector position;  // relative to the centre (m)
  PlaneVector velocity;  // omega x r + dR/dt e_r (m/s), at the time of the position
};

inline WallDiscState wall_disc_state(const RingState& ring, const PlaneVector& reference) {
  const PlaneVector radial{ring.cosine * reference.x - ring.sine * reference.y,
                           ring.sine * reference.x + ring.cosine * reference.y};
  const double tangential_velocity = ring.rotation_rate * ring.radius;
  return {{ring.radius * radial.x, ring.radius * radial.y},
          {ring.radial_velocity * radial.x - tangential_velocity * radial.y,
           ring.radial_velocity * radial.y + tangential_velocity * radial.x}};
}

// Reference unit vector u of a disc at `position` (relative to the centre, non-zero) on a ring in state
// `ring`: the inverse of wall_disc_state().
inline PlaneVector reference_direction(const RingState& ring, const PlaneVector& position) {
  const double distance = std::hypot(position.x, position.y);
  return {(ring.cosine * position.x + ring.sine * position.y) / distance,
          (ring.cosine * position.y - ring.sine * position.x) / distance};
}

}  // namespace mikromakro::physics
