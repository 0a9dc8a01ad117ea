// SPDX-License-Identifier: GPL-2.0-or-later
// Colours, and the map from numbers to colours.
#pragma once

namespace mikromakro {

/// Red, green, blue and opacity, each 0 to 1.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;
};

/// The viridis map (van der Walt and Smith, matplotlib, CC0) at x, clamped to 0 to 1. Perceptually uniform,
/// also for colour-blind readers, and monotonic in lightness, so it survives printing in grey.
Colour viridis(double x);

/// CIE lightness L*, 0 (black) to 100 (white), of an opaque sRGB colour.
double lightness(const Colour& colour);

}  // namespace mikromakro
