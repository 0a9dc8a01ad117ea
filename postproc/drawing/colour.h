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

/// What a colour stands for, in pictures and in pages.
namespace colours {
inline constexpr Colour ink{0.1, 0.1, 0.1, 1};
inline constexpr Colour wall{0.62, 0.62, 0.62, 1};  ///< discs that are not averaged
inline constexpr Colour plain{0.9, 0.9, 0.9, 1};    ///< discs without a quantity
inline constexpr Colour outline{0, 0, 0, 0.4};      ///< of discs
inline constexpr Colour network{0.15, 0.15, 0.15, 0.9};
inline constexpr Colour compression{0.05, 0.05, 0.05, 1};
inline constexpr Colour tension{0.84, 0.1, 0.11, 1};
inline constexpr Colour halo{1, 1, 1,
                             0.75};  ///< along chains, so that they stand out from discs of any colour
}  // namespace colours

/// The viridis map (van der Walt and Smith, matplotlib, CC0) at x, clamped to 0 to 1. Perceptually uniform,
/// also for colour-blind readers, and monotonic in lightness, so it survives printing in grey.
Colour viridis(double x);

/// CIE lightness L*, 0 (black) to 100 (white), of an opaque sRGB colour.
double lightness(const Colour& colour);

}  // namespace mikromakro
