// SPDX-License-Identifier: GPL-2.0-or-later
// The scale of the colours beside a picture.
#pragma once

#include "drawing/canvas.h"
#include "drawing/picture.h"

namespace mikromakro {

/// Colours of a quantity's values, straight from one end of the limits to the other.
class ColourScale {
 public:
  explicit ColourScale(const Limits& limits);

  Colour operator()(double value) const { return viridis((value - low_) / (high_ - low_)); }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_;
  double high_;
};

/// Draws the bar with round numbers, unit and label into the column between the two corners; pointed ends
/// where values lie beyond it, blocks for whole numbers. `letter`: height of the letters (pixels).
void draw_colour_bar(Canvas& canvas, const QuantityInfo& quantity, const PictureScales& scales,
                     const Pixel& corner, const Pixel& opposite, double letter);

}  // namespace mikromakro
