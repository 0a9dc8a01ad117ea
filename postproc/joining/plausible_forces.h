// SPDX-License-Identifier: GPL-2.0-or-later
// Plausibility of the forces of a whole frame, which cannot be judged from single rows.
#pragma once

#include <vector>

#include "joining/contact_geometry.h"
#include "model/frame.h"
#include "model/raw_frame.h"

namespace mikromakro {

/// Notes if all forces are 0 although discs overlap, and if forces are not repulsive overall: with f_n = -f.n
/// of each pair of discs, sum f_n < sum |f|/4; for few contacts, where a dashpot may pull, sum f_n < -sum
/// |f|/4. Without cohesion, contact forces are repulsive, and friction rotates them by less than 45 degrees,
/// whereas swapped ids or columns rotate or reverse all of them. Samples some contacts of each frame, and
/// checks all of them if the sample is not repulsive. Does nothing if forces are not given (nan).
void note_forces(const std::vector<Contact>& contacts, const ContactRules& rules);

/// The same of the contacts with walls alone, all of them, from five on; and if their forces are more than a
/// hundred times those of pairs on average. Walls are few and their rows are often of another file, so that a
/// wrong sign or unit would hide among the pairs.
void note_wall_forces(const std::vector<Contact>& contacts, const ContactRules& rules);

/// Notes if overlaps are derived from coordinates (no column gives them) and are on average less than a third
/// of the rounding error of these: strain and stiffness would then be rounding noise. Does nothing if no
/// field needs overlaps.
void note_derived_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts,
                           const ContactRules& rules);

}  // namespace mikromakro
