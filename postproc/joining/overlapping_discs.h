// SPDX-License-Identifier: GPL-2.0-or-later
// Overlapping discs, found from positions alone: contacts missing from a file, and discs lying on top of one
// another.
#pragma once

#include <vector>

#include "joining/contact_geometry.h"
#include "model/raw_frame.h"

namespace mikromakro {

struct DiscPair {
  int first = -1;  ///< the smaller of the two disc indices
  int second = -1;
  double overlap = 0;      ///< a_1 + a_2 - |branch|, > 0
  Eigen::Vector2d branch;  ///< from the first disc to the image of the second, m
};

/// All pairs of overlapping discs, in ascending order. In a periodic box a pair is listed once for each image
/// that overlaps, including a disc with its own images (one of each opposite pair). Cost is about linear in
/// the number of discs, whatever their sizes.
std::vector<DiscPair> overlapping_discs(const std::vector<Particle>& discs, const Box& box);

/// Notes discs that overlap by more than half a radius, and pairs that overlap by more than the precision of
/// the file but are missing from `contacts`. The frame must have contact data.
void note_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts, const ContactRules& rules);

}  // namespace mikromakro
