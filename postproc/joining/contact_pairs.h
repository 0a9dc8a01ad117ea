// SPDX-License-Identifier: GPL-2.0-or-later
// Each pair once.
#pragma once

#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"

namespace mikromakro {

/// Throws: a pair listed twice (unless through different periodic images; a disc may touch a mesh at several
/// sides). Contact k is that of row row_of[k].
void check_pairs(const std::vector<Contact>& contacts, const std::vector<std::size_t>& row_of,
                 const ContactRows& rows, const std::vector<Particle>& discs, const Box& box);

}  // namespace mikromakro
