// SPDX-License-Identifier: GPL-2.0-or-later
// Discs that overlap, whatever the rows of contacts say: contacts that a file lacks, and discs that lie on
// one another.
#pragma once

#include <vector>

#include "joining/contact_geometry.h"
#include "model/raw_frame.h"

namespace mikromakro {

struct DiscPair {
  int first = -1;  ///< index of a disc, the smaller one
  int second = -1;
  double overlap = 0;      ///< a_1 + a_2 - |branch|, > 0
  Eigen::Vector2d branch;  ///< from the first to the image of the second, m
};

/// All pairs of discs that overlap, in ascending order; in a periodic box once for each image that overlaps,
/// a disc with its own images too (both of a side are one). About as many operations as there are discs, of
/// whatever sizes.
std::vector<DiscPair> overlapping_discs(const std::vector<Particle>& discs, const Box& box);

/// Notes discs that overlap by more than half a radius, and pairs that overlap by more than the digits of the
/// file though `contacts` of the frame (which it has) do not name them.
void note_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts, const ContactRules& rules);

}  // namespace mikromakro
