// SPDX-License-Identifier: GPL-2.0-or-later
// Round numbers and units for scales.
#pragma once

#include <string>
#include <vector>

namespace mikromakro {

/// The largest of 1, 2, 5 times a power of ten that is <= x, x > 0.
double round_below(double x);

/// Round, equally spaced numbers within low..high, about `count` of them.
std::vector<double> ticks(double low, double high, int count);

/// A unit with the SI prefix that brings `size` into 1...1000: divide values by `factor`.
struct ScaledUnit {
  double factor = 1;
  std::string unit;
};
/// No prefix for 0, for values beyond the prefixes, and if `unit` is empty.
ScaledUnit scaled_unit(double size, const std::string& unit);

/// A number for a label, with as few digits as it needs, at most six.
std::string label_text(double value);

}  // namespace mikromakro
