// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts from rows: looks up the discs by id, checks the geometry given in the row against that of the
// discs, and derives what the file does not give.
#pragma once

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/id_map.h"
#include "model/notes.h"

namespace mikromakro {

/// The particles that rows are joined to.
struct ContactDiscs {
  const std::vector<Particle>& particles;
  const IdMap& ids;
  const Box& box;
  double place_error = not_given;  ///< rounding error of coordinates (m); nan: inferred from their digits
};

/// User options for the rows, and where to note rows that are omitted.
struct ContactRules {
  bool distant = false;  ///< forces may act between discs that do not touch
  Notes* notes = nullptr;
  std::int64_t step = Notes::whole;
  std::vector<int> averaged_types = {};  ///< contacts of others may be missing; empty: none may
  bool closely = true;                   ///< including the checks that not every frame has to undergo
};

/// Joins the contacts of one frame.
///
/// The normal is taken from nx, ny; else from x1 y1 x2 y2 (for a wall, x2, y2 is the contact point); else
/// from the positions of the discs. The periodic image of disc 2 is the one given by the row's normal or
/// positions; if there is a column `periodic`, only for rows where it is 1. Otherwise it is the nearest
/// image. If there is no column for it, the overlap is a_1 + a_2 - |r_1 - r_2| (a_2 = 0 for a wall) or
/// follows from dist; the force follows from fn and ft if fx and fy are missing, and the spring from shearx,
/// sheary if xi is. Rows without force whose discs do not touch are neighbour pairs rather than contacts:
/// they are left out and noted. Overlaps of more than half the smaller radius are noted as well, and
/// tangential springs longer than a radius.
///
/// Throws on: an id without a particle; positions, normal, overlap or distance of a row that disagree with
/// its discs beyond the precision of the files; a force between discs that do not touch, unless the rules
/// allow it; springs that push along with the tangential forces of most contacts (xi: if `closely`); periodic
/// = 1 for discs that are far apart in a non-periodic box; a disc in contact with itself other than through a
/// periodic boundary; discs that may touch through two images if the row does not say which; a wall contact
/// without normal or positions; two centres at the same point; and on everything that check_pairs throws on.
std::vector<Contact> join_contacts(const ContactRows& rows, const ContactDiscs& discs,
                                   const ContactRules& rules = {});

}  // namespace mikromakro
