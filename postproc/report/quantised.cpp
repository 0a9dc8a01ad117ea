// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/quantised.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mikromakro {

Quantiser::Quantiser(const Limits& limits, int bits, bool whole)
    : low_(limits.empty() ? 0 : limits.low), step_(1), unknown_(static_cast<std::uint16_t>((1 << bits) - 1)) {
  const double steps = unknown_ - 1;
  const double range = limits.empty() ? 0 : limits.high - limits.low;
  if (range > 0 && !(whole && range <= steps)) step_ = range / steps;
}

std::uint16_t Quantiser::code(double number) const {
  if (std::isnan(number)) return unknown_;
  return static_cast<std::uint16_t>(std::clamp(std::round((number - low_) / step_), 0.0, unknown_ - 1.0));
}

double Quantiser::value(std::uint16_t code) const {
  return code == unknown_ ? std::numeric_limits<double>::quiet_NaN() : low_ + step_ * code;
}

}  // namespace mikromakro
