// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of a frame that a page shows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// A quantity of discs or contacts, and the bits in which a page keeps it.
struct SceneColumn {
  std::string_view name;
  std::string_view unit;  ///< SI, empty if dimensionless
  int bits;
  bool whole = false;  ///< whole numbers, kept as they are
};

/// x, y, radius, vx, vy, spin, type, pressure.
std::span<const SceneColumn> disc_scene_columns();
/// angle of the normal from disc 1 to disc 2 (0 to 2 pi), overlap, normal force (> 0 under compression) and
/// tangential force on disc 1 along t = (-n_y, n_x).
std::span<const SceneColumn> contact_scene_columns();

/// Discs by ascending id, contacts by their discs. Numbers that the input does not have are nan.
struct SceneFrame {
  std::vector<std::int64_t> ids;
  std::vector<std::vector<double>> discs;     ///< of each column
  std::vector<std::uint32_t> first, second;   ///< places in `ids`; a wall with id2 <= 0 is 2^32 - 1 + id2
  std::vector<std::vector<double>> contacts;  ///< of each column
};

/// `height`: thickness (m), for the pressure. Along periodic axes discs are moved into the box.
SceneFrame scene_frame(const Frame& frame, double height);

}  // namespace mikromakro
