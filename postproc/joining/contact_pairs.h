// SPDX-License-Identifier: GPL-2.0-or-later
// Checks that each pair is listed once.
#pragma once

#include <cstdint>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/notes.h"

namespace mikromakro {

/// Throws on a pair that is listed twice, except through different periodic images or on several faces of a
/// mesh, and on a wall contact that is present in both files under different wall ids. Contact k comes from
/// row row_of[k].
void check_pairs(const std::vector<Contact>& contacts, const std::vector<std::size_t>& row_of,
                 const ContactRows& rows, const std::vector<Particle>& discs, const Box& box);

/// Notes discs that touch two walls on the same side by the same overlap. Both may act, where a script
/// defines a wall twice.
void note_walls_twice(const std::vector<Contact>& contacts, const std::vector<Particle>& discs, Notes& notes,
                      std::int64_t step);

}  // namespace mikromakro
