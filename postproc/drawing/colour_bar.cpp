// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/colour_bar.h"

#include <array>
#include <cmath>

#include "drawing/scale_numbers.h"

namespace mikromakro {
namespace {

constexpr Colour ink{0.1, 0.1, 0.1, 1};

bool counts(const QuantityInfo& quantity) {
  return quantity.quantity == DiscQuantity::contacts || quantity.quantity == DiscQuantity::type;
}

// Values along the bar; integers get a margin of half a unit on both sides.
Limits range_of(const QuantityInfo& quantity, const ColourScale& colours) {
  const double margin = counts(quantity) ? 0.5 : 0.0;
  return {colours.low() - margin, colours.high() + margin};
}

// Position of values on the bar, from bottom (low) to top (high).
struct Bar {
  double left, right, top, bottom;
  Limits range;

  double y(double value) const {
    return bottom - (bottom - top) * (value - range.low) / (range.high - range.low);
  }
};

void fill(Canvas& canvas, const Bar& bar, const ColourScale& colours, bool blocks) {
  const int pieces = blocks ? static_cast<int>(std::lround(bar.range.high - bar.range.low)) : 256;
  const double step = (bar.range.high - bar.range.low) / pieces;
  for (int i = 0; i < pieces; ++i) {
    const double low = bar.range.low + i * step;
    // Each piece extends to the end of the bar, so that no seams show.
    const double upper = blocks ? bar.y(low + step) : bar.top;
    const std::array<Pixel, 4> corners = {
        {{bar.left, bar.y(low)}, {bar.right, bar.y(low)}, {bar.right, upper}, {bar.left, upper}}};
    canvas.polygon(corners, colours(low + 0.5 * step));
  }
}

void point(Canvas& canvas, const Bar& bar, double from, double to, const Colour& colour) {
  const std::array<Pixel, 3> corners = {
      {{bar.left, from}, {0.5 * (bar.left + bar.right), to}, {bar.right, from}}};
  canvas.polygon(corners, colour);
}

}  // namespace

ColourScale::ColourScale(const Limits& limits) : low_(limits.low), high_(limits.high) {
  if (limits.empty()) high_ = (low_ = 0) + 1;
  // A single value gets the middle of the map.
  if (low_ == high_) {
    const double side = low_ == 0 ? 1 : 0.05 * std::abs(low_);
    low_ -= side;
    high_ += side;
  }
}

void draw_colour_bar(Canvas& canvas, const QuantityInfo& quantity, const PictureScales& scales,
                     const Pixel& corner, const Pixel& opposite, double letter) {
  const Limits given = counts(quantity) ? scales.values : scales.colours;
  const ColourScale colours = counts(quantity) && given.low == given.high
                                  ? ColourScale({given.low - 1, given.high + 1})
                                  : ColourScale(given);
  const double part = 0.1 * (opposite.y() - corner.y());
  const Bar bar{corner.x(), corner.x() + 1.1 * letter, corner.y() + part, opposite.y() - part,
                range_of(quantity, colours)};
  const double tip = 1.2 * letter;
  if (scales.values.high > colours.high())
    point(canvas, bar, bar.top, bar.top - tip, colours(colours.high()));
  if (scales.values.low < colours.low())
    point(canvas, bar, bar.bottom, bar.bottom + tip, colours(colours.low()));
  fill(canvas, bar, colours, counts(quantity));
  canvas.frame({bar.left, bar.top}, {bar.right, bar.bottom}, 0.06 * letter, ink);

  const ScaledUnit unit =
      scaled_unit(std::max(std::abs(colours.low()), std::abs(colours.high())), std::string(quantity.unit));
  std::size_t longest = 0;
  for (double tick : ticks(bar.range.low / unit.factor, bar.range.high / unit.factor, 6)) {
    if (counts(quantity) && tick != std::round(tick)) continue;
    const double y = bar.y(tick * unit.factor);
    const std::string label = label_text(tick);
    longest = std::max(longest, label.size());
    canvas.line({bar.right, y}, {bar.right + 0.3 * letter, y}, 0.06 * letter, ink);
    canvas.text({bar.right + 0.5 * letter, y}, label, letter, {0, 0.5});
  }
  const std::string in = unit.unit.empty() ? "" : " (" + unit.unit + ")";
  const double x = bar.right + (1.5 + 0.62 * static_cast<double>(longest)) * letter;
  canvas.text({x, 0.5 * (bar.top + bar.bottom)}, std::string(quantity.label) + in, letter, {0.5, 0.5}, true);
}

}  // namespace mikromakro
