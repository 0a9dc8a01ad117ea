// Discs that overlap, whatever the rows of contacts say: contacts that a file lacks, and discs that lie on
// one another.
#pragma once

#include <vector>

#include "io/contact_geometry.h"
#include "io/frame_format.h"

namespace mikromakro {

struct DiscPair {
  int first = -1;  ///< index of a disc, the smaller one
  int second = -1;
  double overlap = 0;  ///< a_1 + a_2 - distance of the nearest images, > 0
};

/// All pairs of discs that overlap, each once, in ascending order. In a periodic box it is the nearest image
/// that counts; a disc and its own image are no pair. About as many operations as there are discs, of
/// whatever sizes.
std::vector<DiscPair> overlapping_discs(const std::vector<Particle>& discs, const Box& box);

/// Notes discs that overlap by more than half a radius, and pairs that overlap by more than the digits of the
/// file though `contacts` of the frame (which it has) do not name them.
void note_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts, const ContactRules& rules);

}  // namespace mikromakro
