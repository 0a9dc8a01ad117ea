// SPDX-License-Identifier: GPL-2.0-or-later
// Integrals of kernels along circles.
#pragma once

#include "averaging/kernels/kernel.h"

namespace mikromakro {

/// A circle of radius R >= 0 about an origin at distance d >= 0 from the centre of the kernel. Never throws.
class CircleSweep {
 public:
  CircleSweep(const Kernel& kernel, double d, double R);

  /// Integral of e/(2 pi) dtheta, as in Kernel::line_sweep, along the circle, counter-clockwise from angle
  /// `begin` to `end` >= begin, measured from the direction of the kernel's centre; at most one turn. To
  /// 1e-11.
  double arc(double begin, double end) const;
  /// Fraction of the kernel inside the circle. To 1e-11.
  double whole() const;

 private:
  double half_arc(double begin, double end) const;
  double within_reach(double begin, double end) const;
  double direction(double delta) const;

  const Kernel& kernel_;
  double d_;
  double R_;
  double leaves_;  // angle at which the circle leaves the support of the kernel
};

}  // namespace mikromakro
