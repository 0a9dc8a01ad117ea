// SPDX-License-Identifier: GPL-2.0-or-later
// What a run simulates and what it leaves out, as one line for screen and log.
#pragma once

#include <string>
#include <vector>

#include "physics/contact_law.h"

namespace LAMMPS_NS {
class Modify;
}

namespace mikromakro::styles {

/// Names of the effects of the contact law and of the fixes that are defined: bottom friction, gravity,
/// smooth walls (ours), walls of the engine (its fixes wall/...).
std::vector<std::string> simulated_effects(const physics::Effects& law, const LAMMPS_NS::Modify& modify);

/// "Effects simulated: ...; not simulated: ...; dashpots see ... velocities".
std::string effects_line(const physics::Effects& law, const LAMMPS_NS::Modify& modify,
                         bool predicted_velocities);

}  // namespace mikromakro::styles
