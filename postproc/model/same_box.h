// SPDX-License-Identifier: GPL-2.0-or-later
// Particles and contacts of one step of one run share one box.
#pragma once

#include "model/error.h"
#include "model/frame.h"

namespace mikromakro {

/// Whether a side that does not follow the discs changes by more than a tenth, which is more than in a
/// deforming box from one frame to the next.
bool jumps(const Box& before, const Box& after);

/// The note if the number of discs changes as well.
inline constexpr const char* another_system =
    "the box and the number of discs are not those of the earlier frames (another run?)";

/// Whether a side along a periodic axis more than doubles or halves, which hardly occurs within a run from
/// one frame to the next. Other sides may be shrink-wrapped.
bool is_another(const Box& before, const Box& after);

inline constexpr const char* another_box =
    "a side of the box is more than twice or less than half as long as in the previous frame (a damaged "
    "header?)";

/// Throws if the box has zero width along a periodic axis, or if its bounds are out of order.
void check_box(const Box& box, const Place& place);

/// Throws if the box in the contact header, located at `place`, differs from that of the particles: bounds to
/// five digits, boundaries if both files give them.
void check_same_box(const Box& of_particles, const Box& of_contacts, const Place& place);

}  // namespace mikromakro
