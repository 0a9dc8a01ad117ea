// Makes the disc styles known to an engine.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Adds the fixes, computes and commands of mikromakro to the tables of one engine and the contact laws to
/// the engine's factories. Called for every new engine and again after `clear`; calling it twice changes
/// nothing.
void register_styles(LAMMPS_NS::LAMMPS& engine);

/// One line: name and version of mikromakro and of the engine.
std::string version_line();

/// Names of the registered styles, for -help.
std::string style_list();

}  // namespace mikromakro::styles
