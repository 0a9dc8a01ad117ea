// SPDX-License-Identifier: GPL-2.0-or-later
// Plausibility of the tangential springs of a whole frame, which cannot be judged from single rows.
#pragma once

#include <vector>

#include "joining/contact_geometry.h"
#include "model/contact_rows.h"
#include "model/frame.h"

namespace mikromakro {

/// Springs act against their displacement: -f_t xi > 0. A tangential force in the spring columns does not,
/// nor does the slip of 2 relative to 1, which shows in a frame with many contacts; a dashpot parallel to the
/// spring reverses f_t in some of them. Throws (bad input) if they push; xi is looked at only if `closely`.
void check_springs_pull_back(const ContactRows& rows, const std::vector<Contact>& contacts, bool closely);

/// Notes springs whose size cannot be: f_t/xi over f_n/overlap is about k_t/k_n, near 1 (soft springs:
/// 1/200), for contacts that stick and, with both at the Coulomb limit, for those that slide; dashpots
/// scatter it. A sample suffices in frames not checked closely.
void note_size_of_springs(const std::vector<Contact>& contacts, const ContactRules& rules);

/// Notes springs that are not correlated with the tangential forces of the same contacts, as f_t = -k_t xi
/// [- gamma_t v_t] makes them: a rank correlation above -4/sqrt(n), for n >= 100 of them (at most
/// 2000) in a frame checked closely. By chance that happens in one of 3e4 frames of another quantity.
void note_springs_without_force(const std::vector<Contact>& contacts, const ContactRules& rules);

}  // namespace mikromakro
