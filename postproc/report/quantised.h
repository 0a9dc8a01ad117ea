// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as whole numbers of a few bits.
#pragma once

#include <cstdint>

#include "drawing/picture.h"

namespace mikromakro {

/// Codes 0, 1, ... stand for low, low + step, ...; the largest code stands for nan.
class Quantiser {
 public:
  /// Splits the limits into 2^bits - 2 equal steps, bits <= 16; for `whole` numbers the steps are 1, unless
  /// that is too many. Empty limits: every number is nan.
  Quantiser(const Limits& limits, int bits, bool whole = false);

  /// The nearest code: value() is off by step()/2 at most, and rounding, for numbers within the limits.
  std::uint16_t code(double number) const;
  double value(std::uint16_t code) const;

  double low() const { return low_; }
  double step() const { return step_; }
  std::uint16_t unknown() const { return unknown_; }

 private:
  double low_;
  double step_;
  std::uint16_t unknown_;
};

}  // namespace mikromakro
