// SPDX-License-Identifier: GPL-2.0-or-later
// Forces on discs that are missing from our outputs.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Warns once, at the start of a run, if fixes (or bond styles) exert or may exert contact-like forces on
/// discs while one of our computes or fixes outputs contacts; names them all. Known body forces such as
/// gravity are exempt; every unknown fix is named.
void warn_of_unseen_forces(LAMMPS_NS::LAMMPS& engine);

}  // namespace mikromakro::styles
