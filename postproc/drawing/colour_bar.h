// SPDX-License-Identifier: GPL-2.0-or-later
// The colour bar of a picture.
#pragma once

#include "drawing/canvas.h"
#include "drawing/picture.h"

namespace mikromakro {

/// Maps the values of a quantity to colours, linearly between the limits.
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

/// Draws the bar with round tick values, unit and label into the rectangle between the two corners; pointed
/// ends if values lie beyond it, blocks for integers. `letter`: letter height (pixels).
void draw_colour_bar(Canvas& canvas, const QuantityInfo& quantity, const PictureScales& scales,
                     const Pixel& corner, const Pixel& opposite, double letter);

}  // namespace mikromakro
