// SPDX-License-Identifier: GPL-2.0-or-later
// Packed disc data of the pair loop: contiguous rows, loaded and stored as vectors of four doubles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "physics/math/plane_vector.h"

namespace mikromakro::physics {

/// SIMD vector of four doubles, on any processor.
using Four [[gnu::vector_size(32), gnu::aligned(32)]] = double;

/// Disc data read by the pair loop; fills one cache line.
struct alignas(64) DiscRow {
  Four place;   // x, y, radius, radius [m]
  Four motion;  // v_x, v_y [m/s], spin [1/s], spin times radius [m/s]

  static DiscRow of(double x, double y, double radius) {
    return DiscRow{Four{x, y, radius, radius}, Four{0, 0, 0, 0}};
  }
  double x() const { return place[0]; }
  double y() const { return place[1]; }
  double radius() const { return place[2]; }
  PlaneVector velocity() const { return {motion[0], motion[1]}; }
  double spin() const { return motion[2]; }
  void move_to(double x, double y) {
    place[0] = x;
    place[1] = y;
  }
  void set_motion(double v_x, double v_y, double spin) { motion = Four{v_x, v_y, spin, spin * place[2]}; }
};

/// Sums over the contacts of a disc: f_x, f_y, f_t [N] and f_t overlap / 2 [N m]. The lever arm of a contact
/// is radius - overlap/2, so these two sums give the torque without the radius in the pair loop.
struct alignas(32) DiscLoad {
  Four sums{0, 0, 0, 0};

  void add_force(double f_x, double f_y) { sums += Four{f_x, f_y, 0, 0}; }
  /// Adds a wall's torque [N m] on a disc of the given radius [m]. Call after all contacts of the disc:
  /// rounds as adding it to their summed torque would.
  void add_torque(double torque_of_wall, double radius) {
    sums[3] = -(torque(radius) + torque_of_wall);
    sums[2] = 0;
  }
  double f_x() const { return sums[0]; }
  double f_y() const { return sums[1]; }
  double torque(double radius) const { return radius * sums[2] - sums[3]; }
};

/// True if rows and loads of this many discs exceed a typical cache, so that prefetching pays (measured:
/// costs 4 % at 3 MB, gains 8 % at 10 MB and a third at 30 MB).
constexpr bool rows_exceed_cache(std::size_t discs) {
  return discs * (sizeof(DiscRow) + sizeof(DiscLoad)) > 8000000;
}

/// Sign patterns for a pair. Positions, 2 - 1: d_x, d_y, sum and difference of the radii. Motions, 1 - 2:
/// difference of the velocities, sums of spins and of rim speeds. Load on 2: that on 1 with the force
/// reversed.
inline constexpr Four sign_of_place = {-1, -1, 1, -1}, sign_of_motion = {-1, -1, 1, 1},
                      sign_of_load = {-1, -1, 1, 1};

/// Transposes a 4 x 4 matrix of rows a, b, c, d in place.
[[gnu::always_inline]] inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four low_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four high_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four low_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four high_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
  c = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
  d = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
}

}  // namespace mikromakro::physics
