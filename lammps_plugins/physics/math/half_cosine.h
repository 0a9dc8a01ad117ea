// SPDX-License-Identifier: GPL-2.0-or-later
// Smooth transition between two values: z(t) = z_f + (z_0 - z_f)/2 (1 + cos(pi t/T)) for t < T, then z_f. The
// rate is zero at both ends, so a driven wall starts and stops without a jump in velocity.
#pragma once

#include <cmath>
#include <numbers>

namespace mikromakro::physics {

// T = 0: at the end value from the start.
struct HalfCosine {
  double start = 0.0;     // z_0
  double end = 0.0;       // z_f
  double duration = 0.0;  // T (s)

  [[nodiscard]] double value(double time) const {
    if (time >= duration) return end;
    return end + 0.5 * (start - end) * (1.0 + std::cos(std::numbers::pi * time / duration));
  }
  // dz/dt
  [[nodiscard]] double rate(double time) const {
    if (time >= duration) return 0.0;
    const double frequency = std::numbers::pi / duration;
    return 0.5 * (end - start) * frequency * std::sin(frequency * time);
  }
};

}  // namespace mikromakro::physics
