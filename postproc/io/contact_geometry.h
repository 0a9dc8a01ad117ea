// Contacts from rows: the discs found by their ids, normal and overlap derived where the file does not give
// them.
#pragma once

#include "io/contact_reader.h"
#include "io/frame.h"
#include "io/id_map.h"

namespace mikromakro {

/// Contacts of one frame.
///
/// The normal is taken from nx, ny; else from x1 y1 x2 y2 (a wall's x2, y2 is the contact point); else from
/// the positions of the discs. In the last two cases the nearest periodic image of disc 2 is taken; where
/// there is a column `periodic`, only for rows that have 1 there.  overlap = a_1 + a_2 - |r_1 - r_2| (a_2 = 0
/// for a wall) where no column gives it. Throws: an id without particle, a disc in contact with itself
/// (unless through a periodic boundary), a pair listed twice (unless through different periodic images), a
/// wall contact without normal or positions, two centres at the same point.
std::vector<Contact> join_contacts(const ContactRows& rows, const std::vector<Particle>& particles,
                                   const IdMap& ids, const Box& box);

}  // namespace mikromakro
