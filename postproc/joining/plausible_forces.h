// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of a frame as a whole: what no single row can tell.
#pragma once

#include <vector>

#include "joining/contact_geometry.h"
#include "model/frame.h"
#include "model/raw_frame.h"

namespace mikromakro {

/// Notes where all forces are 0 though discs overlap, and where forces do not push: with f_n = -f.n of each
/// contact, sum f_n < sum |f|/4; of few contacts, in which a dashpot may pull, sum f_n < -sum |f|/4. Discs
/// that only touch push, and friction turns their forces by less than 45 degrees; exchanged ids or columns
/// turn all of them. Looks at some contacts of each frame, at all where these do not push. Nothing where
/// forces are not given (nan).
void note_forces(const std::vector<Contact>& contacts, const ContactRules& rules);

/// Notes overlaps that no row tells and that are, on average, less than a third of what the coordinates they
/// are derived from have lost: strain and stiffness are then those of digits. Nothing where no field needs
/// overlaps.
void note_derived_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts,
                           const ContactRules& rules);

}  // namespace mikromakro
