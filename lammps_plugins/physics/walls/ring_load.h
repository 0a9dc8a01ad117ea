// SPDX-License-Identifier: GPL-2.0-or-later
// Load of the discs on a ring of the cell: torque about the centre and radial force, summed over the ring's
// wall discs.
#pragma once

#include <cmath>
#include <numbers>

#include "physics/motion/ring_motion.h"

namespace mikromakro::physics {

struct RingLoad {
  double torque = 0.0;         // N m, counter-clockwise positive
  double outward_force = 0.0;  // sum of f . e_r (N)

  // Adds one wall disc: its position relative to the ring's centre, the force on it, and the torque about its
  // own centre, because contacts act at its rim rather than its centre.
  void add(const PlaneVector& position, const PlaneVector& force, double own_torque) {
    torque += position.x * force.y - position.y * force.x + own_torque;
    outward_force += (position.x * force.x + position.y * force.y) / std::hypot(position.x, position.y);
  }
};

// Pressure on a ring of radius R (m): force away from the discs per circumference (N/m), or Pa if divided by
// a cell height. Positive in compression: the discs push an inner ring inwards, an outer ring outwards.
enum class RingSide { inner, outer };
inline double ring_pressure(RingSide side, const RingLoad& load, double radius, double height) {
  const double away_from_discs = side == RingSide::inner ? 0.0 - load.outward_force : load.outward_force;
  return away_from_discs / (2.0 * std::numbers::pi * radius * height);
}

// Power fed into the discs by a ring rotating at `rotation_rate` (1/s), in W: the torque of the ring on the
// discs, i.e. minus the torque on the ring, times the rate.
inline double ring_power(const RingLoad& load, double rotation_rate) {
  return (0.0 - load.torque) * rotation_rate;
}

// Number of equally spaced wall discs closest to the requested pitch: round(2 pi R / pitch).
inline long ring_count(double radius, double pitch) {
  return std::lround(2.0 * std::numbers::pi * radius / pitch);
}

}  // namespace mikromakro::physics
