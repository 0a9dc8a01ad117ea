// SPDX-License-Identifier: GPL-2.0-or-later
// What is looked at once for all discs, at the start of a run.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Ends the run where a disc has no radius or no mass, or where a second fix integrates a disc of fix
/// nve/disc, or a periodic box is so narrow that contacts or springs are lost; warns of masses that are those
/// of spheres. `style` is who asks, `with_springs` whether its contacts have a history.
void check_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style, bool with_springs);

}  // namespace mikromakro::styles
