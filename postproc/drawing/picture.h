// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of frames: discs coloured by a quantity, contact network, force chains, scales.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "drawing/disc_quantity.h"
#include "model/frame.h"

namespace mikromakro {

/// Line widths, in mean radii of the discs: a chain that carries the mean force, a contact of the network,
/// and the halo along a chain.
inline constexpr double chain_width = 0.2;
inline constexpr double network_width = 0.09;
inline constexpr double halo_width = 0.08;

/// What to draw, and at what size.
struct PictureStyle {
  const QuantityInfo* quantity = nullptr;  ///< null: discs in light grey, no colour bar
  bool network = false;
  bool chains = false;
  std::vector<int> bulk_types;  ///< empty: all; discs of other types are walls, drawn in grey
  bool border = false;          ///< outline the visible part of the plane
  double height = 1;            ///< thickness (m), for the pressure
  int width = 1600;             ///< of the whole picture, pixels
  double time_step = 0;         ///< s, > 0: the stamp gives the time instead of the step
};

/// Whether the disc is coloured rather than drawn as a wall.
bool is_bulk(const Particle& particle, const PictureStyle& style);

/// A range of numbers; empty until something is added.
struct Limits {
  double low = 0;
  double high = -1;

  bool empty() const { return low > high; }
  void add(double number);
  void add(const Limits& other);
};

/// Common to all pictures of a sequence: visible part of the plane, colours and line widths.
struct PictureScales {
  std::optional<Box> window;  ///< by default the extent of the discs, or the periodic box
  Limits colours;             ///< ends of the colour bar; values beyond get the end colours
  Limits values;              ///< of the bulk discs
  double mean_force = 0;      ///< of abs(f_n) over all contacts (N)
  std::int64_t contacts = 0;

  /// Extends the scales to this frame. Colours end at the 99th percentile (for speeds, spins and pressures,
  /// which have few outliers); spins get symmetric limits.
  void add(const Frame& frame, const PictureStyle& style);
};

/// Draws one frame. Throws if the window is so narrow that the picture would be higher than 30000 pixels.
std::string draw_picture(const Frame& frame, const PictureStyle& style, const PictureScales& scales,
                         Canvas::Kind kind);

}  // namespace mikromakro
