// Particles and contacts of one step of one run have one box.
#pragma once

#include "io/error.h"
#include "io/frame.h"

namespace mikromakro {

/// Throws where the box above the contacts, which stands at `place`, is not that of the particles: bounds to
/// five digits, boundaries where both files tell them.
void check_same_box(const Box& of_particles, const Box& of_contacts, const Place& place);

}  // namespace mikromakro
