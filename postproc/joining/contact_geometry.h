// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts from rows: the discs found by their ids, the geometry that the row tells set beside that of the
// discs, and derived where the file does not tell it.
#pragma once

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/id_map.h"
#include "model/notes.h"

namespace mikromakro {

/// What the rows are joined to.
struct ContactDiscs {
  const std::vector<Particle>& particles;
  const IdMap& ids;
  const Box& box;
  double place_error = not_given;  ///< what coordinates have lost (m), nan: as their digits say
};

/// What the user says about the rows, and where to note what is left out.
struct ContactRules {
  bool distant = false;  ///< forces may act between discs that do not touch
  Notes* notes = nullptr;
  std::int64_t step = Notes::whole;
  std::vector<int> averaged_types = {};  ///< contacts of others may be missing; empty: of none
};

/// Contacts of one frame.
///
/// The normal is taken from nx, ny; else from x1 y1 x2 y2 (a wall's x2, y2 is the contact point); else from
/// the positions of the discs. The image of disc 2 is the one that the row tells by normal or places, where
/// there is a column `periodic` only for rows that have 1 there; without either the nearest one. overlap =
/// a_1 + a_2 - |r_1 - r_2| (a_2 = 0 for a wall) where no column gives it, or dist; the force from fn and ft
/// where fx and fy are missing; the spring from shearx, sheary where xi is. Rows without force whose discs do
/// not touch are near pairs, no contacts: left out and noted. Noted, too: overlaps of more than half of the
/// smaller radius.
///
/// Throws: an id without particle; places, normal, overlap or distance of a row that are not those of its
/// discs within the digits of the files; a force between discs that do not touch, unless the rules allow it;
/// periodic = 1 for discs whose places are apart in a box that is not periodic; a disc in contact with
/// itself, unless through a periodic boundary; discs that may touch through two images where the row does not
/// say which; a wall contact without normal or positions, two centres at the same point, and what check_pairs
/// throws.
std::vector<Contact> join_contacts(const ContactRows& rows, const ContactDiscs& discs,
                                   const ContactRules& rules = {});

}  // namespace mikromakro
