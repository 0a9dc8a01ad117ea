// SPDX-License-Identifier: GPL-2.0-or-later
// Registers the disc styles with an engine.
#pragma once

#include <map>
#include <string>

#include "dialect.h"

namespace mikromakro::styles {

// Engine-independent styles by their names in scripts; contact laws are registered per engine.
extern const std::map<std::string, FixCreator> disc_fixes;
extern const std::map<std::string, ComputeCreator> disc_computes;
extern const std::map<std::string, CommandCreator> disc_commands;

/// Adds the fixes, computes and commands of mikromakro to the tables of one engine and the contact laws to
/// the engine's factories. Called for every new engine and again after `clear`; idempotent.
void register_styles(LAMMPS_NS::LAMMPS& engine);

/// One line: name and version of mikromakro and of the engine.
std::string version_line();

/// Names of the registered styles, for -help.
std::string style_list();

}  // namespace mikromakro::styles
