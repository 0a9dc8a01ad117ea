// SPDX-License-Identifier: GPL-2.0-or-later
// Momentum balances of rings.
#pragma once

#include <vector>

#include "model/table.h"

namespace mikromakro {

/// Balance of one ring in a steady state.
struct RingBalance {
  double r = 0;             ///< middle radius, m
  double torque = 0;        ///< 2 pi r^2 h sigma_phir, N m: equal to the wheel torque at every r
  double slope = 0;         ///< d(r sigma_rr)/dr, Pa
  double sigma_phiphi = 0;  ///< should equal the slope, Pa
  double pressure = 0;      ///< -tr sigma/2, Pa
  bool counts = false;      ///< far enough from the walls, see below
};

/// Balances of rings from a table of `mikromakro average` with the field stress. d(r sigma_rr)/dr is the
/// slope of the parabola through neighbouring rings. The stress of the discs ends before the wall does: rings
/// that begin less than `margin` (m) from the inner edge of the first ring, or end less than that from the
/// outer edge of the last, do not count in the deviations below, nor do slopes that involve such rings.
std::vector<RingBalance> ring_balances(const Table& table, double height, double margin);

/// Largest |torque/wheel_torque - 1| of the rings that count; nan if none do, or without wheel torque.
double torque_deviation(const std::vector<RingBalance>& rings, double wheel_torque);
/// Largest |d(r sigma_rr)/dr - sigma_phiphi|, relative to the mean pressure, of the rings that count and
/// whose neighbours do; nan if there are none.
double radial_deviation(const std::vector<RingBalance>& rings);

}  // namespace mikromakro
