// SPDX-License-Identifier: GPL-2.0-or-later
// A disordered dense packing in motion: every contact slides, sticks or separates within a few steps.
#pragma once

#include <string>

namespace mikromakro::test {

/// Lines that create side x side discs of two sizes on a jittered triangular lattice that fills the periodic
/// box
/// [-0.1, 0.1]^2 m, compressed to overlaps of some per cent of the radius, with random velocities up to
/// `speed` [m/s] and spins up to speed / radius.
std::string packing(int side, double speed);

/// Half the edge of the box of packing() [m].
inline constexpr double packing_box = 0.1;

}  // namespace mikromakro::test
