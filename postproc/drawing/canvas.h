// SPDX-License-Identifier: GPL-2.0-or-later
// A drawing surface that is saved as PNG or SVG.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>

#include "drawing/colour.h"

namespace mikromakro {

/// A point in pixels from the upper left corner.
using Pixel = Eigen::Vector2d;

/// Which point of a text is placed at its position: 0 left (top), 0.5 middle, 1 right (bottom).
struct Anchor {
  double x = 0;
  double y = 0.5;
};

/// Cairo, reduced to what pictures need. All lengths are in pixels.
class Canvas {
 public:
  enum class Kind { png, svg };

  /// A white canvas. Throws if it cannot be allocated.
  Canvas(Kind kind, int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void disc(const Pixel& centre, double radius, const Colour& fill, const Colour& outline, double line_width);
  void line(const Pixel& from, const Pixel& to, double width, const Colour& colour);
  void polygon(std::span<const Pixel> corners, const Colour& fill);
  void frame(const Pixel& corner, const Pixel& opposite, double width, const Colour& colour);
  /// `upwards`: rotated by 90 degrees, reading from bottom to top.
  void text(const Pixel& at, const std::string& words, double size, Anchor anchor, bool upwards = false);

  /// Clips all drawing to the rectangle, until `show_all`.
  void show_only(const Pixel& corner, const Pixel& opposite);
  void show_all();

  /// The content of the file; nothing can be drawn afterwards. Throws (failed run) if Cairo cannot produce
  /// it.
  std::string encoded();

 private:
  struct Cairo;
  std::unique_ptr<Cairo> cairo_;
};

}  // namespace mikromakro
