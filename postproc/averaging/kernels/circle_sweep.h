// SPDX-License-Identifier: GPL-2.0-or-later
// Integrals of kernels along circles.
#pragma once

#include "averaging/kernels/kernel.h"

namespace mikromakro {

/// The circle of radius R >= 0 around an origin that is d >= 0 away from the centre of the kernel. Never
/// throws.
class CircleSweep {
 public:
  CircleSweep(const Kernel& kernel, double d, double R);

  /// Integral of e/(2 pi) dtheta, as in Kernel::line_sweep, along the circle, counter-clockwise from the
  /// angle `begin` to `end` >= begin, counted from the direction of that centre; at most a turn. To 1e-11.
  double arc(double begin, double end) const;
  /// Part of the kernel within the circle. To 1e-11.
  double whole() const;

 private:
  double half_arc(double begin, double end) const;
  double within_reach(double begin, double end) const;
  double direction(double delta) const;

  const Kernel& kernel_;
  double d_;
  double R_;
  double leaves_;  // angle at which the circle leaves the reach of the kernel
};

}  // namespace mikromakro
