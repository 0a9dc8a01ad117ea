// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of all discs at the start of a run.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Stops the run if a disc has no radius or no mass, if a second fix integrates a disc of fix nve/disc, or if
/// a periodic box is too narrow for contacts or springs. Warns if masses are those of spheres. `style`:
/// caller, for messages; `with_springs`: its contacts have a history.
void check_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style, bool with_springs);

}  // namespace mikromakro::styles
