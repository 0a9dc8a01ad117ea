// SPDX-License-Identifier: GPL-2.0-or-later
// What the discs of a cell do to one of its rings: torque about the centre and radial force, summed over the
// wall discs of the ring.
#pragma once

#include <cmath>
#include <numbers>

#include "physics/ring_motion.h"

namespace mikromakro::physics {

struct RingLoad {
  double torque = 0.0;         // N m, counter-clockwise positive
  double outward_force = 0.0;  // sum of f . e_r (N)

  // One wall disc: its centre relative to the ring's centre, the force on it, and the torque about its own
  // centre, which is the part of the contact's lever arm that the disc's radius makes.
  void add(const PlaneVector& position, const PlaneVector& force, double own_torque) {
    torque += position.x * force.y - position.y * force.x + own_torque;
    outward_force += (position.x * force.x + position.y * force.y) / std::hypot(position.x, position.y);
  }
};

// Pressure on a ring of radius R (m): the force that pushes it away from the discs over its circumference
// (N/m), divided by the height of the cell where one is given (Pa). Positive in compression; the discs push
// an inner ring inwards, an outer one outwards.
enum class RingSide { inner, outer };
inline double ring_pressure(RingSide side, const RingLoad& load, double radius, double height) {
  const double away_from_discs = side == RingSide::inner ? 0.0 - load.outward_force : load.outward_force;
  return away_from_discs / (2.0 * std::numbers::pi * radius * height);
}

// Power that a ring turning at `rotation_rate` (1/s) feeds into the discs (W): the ring's torque on them,
// opposite to theirs on it, times its rate.
inline double ring_power(const RingLoad& load, double rotation_rate) {
  return (0.0 - load.torque) * rotation_rate;
}

// Number of equally spaced wall discs that comes nearest to the pitch asked for: round(2 pi R / pitch).
inline long ring_count(double radius, double pitch) {
  return std::lround(2.0 * std::numbers::pi * radius / pitch);
}

}  // namespace mikromakro::physics
