// SPDX-License-Identifier: GPL-2.0-or-later
// Work done by the first rank on behalf of all.
#pragma once

#include <functional>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Runs `action` on the first rank while the others wait. An exception stops the run on all ranks with
/// "style: what". Collective.
void on_first_rank(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::function<void()>& action);

/// Prints a line on screen and in the log, from the first rank.
void print_line(LAMMPS_NS::LAMMPS& engine, const std::string& line);

/// Issues an engine warning from the first rank.
void warn(LAMMPS_NS::LAMMPS& engine, const std::string& text);

}  // namespace mikromakro::styles
