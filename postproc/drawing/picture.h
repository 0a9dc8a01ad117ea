// SPDX-License-Identifier: GPL-2.0-or-later
// A frame as a picture: discs coloured by a quantity, contact network, force chains, scales.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "drawing/disc_quantity.h"
#include "model/frame.h"

namespace mikromakro {

/// What is drawn, and how large.
struct PictureStyle {
  const QuantityInfo* quantity = nullptr;  ///< none: discs in light grey, no colour bar
  bool network = false;
  bool chains = false;
  std::vector<int> bulk_types;  ///< empty: all; discs of other types are walls, drawn in grey
  bool border = false;          ///< a line around the part of the plane that is shown
  double height = 1;            ///< thickness (m), for the pressure
  int width = 1600;             ///< of the whole picture, pixels
  double time_step = 0;         ///< s, > 0: the stamp gives the time instead of the step
};

/// Whether the disc is coloured, and not a wall.
bool is_bulk(const Particle& particle, const PictureStyle& style);

/// A range of numbers; empty until something is added.
struct Limits {
  double low = 0;
  double high = -1;

  bool empty() const { return low > high; }
  void add(double number);
  void add(const Limits& other);
};

/// What all pictures of a sequence have in common: the part of the plane, colours and widths.
struct PictureScales {
  std::optional<Box> window;  ///< where nothing is asked for, the discs with their radii, or the periodic box
  Limits colours;             ///< ends of the colour bar; numbers beyond get the colours of the ends
  Limits values;              ///< of the bulk discs
  double mean_force = 0;      ///< of abs(f_n) over all contacts (N)
  std::int64_t contacts = 0;

  /// Widens the scales to hold this frame. Colours end at the 99th percentile (for speeds, spins and
  /// pressures, where few discs are far from all others); spins get as much to both sides.
  void add(const Frame& frame, const PictureStyle& style);
};

/// Draws one frame. Throws when the window is so narrow that the picture would be higher than 30000 pixels.
std::string draw_picture(const Frame& frame, const PictureStyle& style, const PictureScales& scales,
                         Canvas::Kind kind);

}  // namespace mikromakro
