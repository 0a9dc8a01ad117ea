// SPDX-License-Identifier: GPL-2.0-or-later
// Particles and contacts of one step of one run have one box.
#pragma once

#include "model/error.h"
#include "model/frame.h"

namespace mikromakro {

/// Whether a side is longer or shorter by more than a tenth: more than a box that a run deforms does from one
/// frame to the next.
bool jumps(const Box& before, const Box& after);

/// The note where the number of discs is another one, too.
inline constexpr const char* another_system =
    "the box and the number of discs are not those of the frames before (another run?)";

/// Whether a side is longer or shorter by more than a third, which hardly any run does between two frames.
bool is_another(const Box& before, const Box& after);

inline constexpr const char* another_box =
    "a side of the box is longer or shorter by more than a third than in the frame before (a damaged "
    "header?)";

/// Throws where a box is of no width along a periodic axis, or its bounds are not in order.
void check_box(const Box& box, const Place& place);

/// Throws where the box above the contacts, which stands at `place`, is not that of the particles: bounds to
/// five digits, boundaries where both files tell them.
void check_same_box(const Box& of_particles, const Box& of_contacts, const Place& place);

}  // namespace mikromakro
