// SPDX-License-Identifier: GPL-2.0-or-later
// One line for screen and log: the effects that a run simulates and those it does not.
#pragma once

#include <string>
#include <vector>

#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class Modify;
}

namespace mikromakro::styles {

/// The effect of the engine's own walls, whose contacts are not in our rows.
inline constexpr const char* engine_walls = "walls of the engine under their own law";
bool has_engine_walls(const LAMMPS_NS::Modify& modify);

/// Names of the effects of the contact law and of the defined fixes: bottom friction, gravity, our smooth
/// walls, the engine's walls (its fixes wall/...).
std::vector<std::string> simulated_effects(const physics::Effects& law, const LAMMPS_NS::Modify& modify);

/// "Effects simulated: ...; not simulated: ...; dashpots see ... velocities".
std::string effects_line(const physics::Effects& law, const LAMMPS_NS::Modify& modify,
                         bool predicted_velocities);

}  // namespace mikromakro::styles
