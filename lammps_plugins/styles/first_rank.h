// SPDX-License-Identifier: GPL-2.0-or-later
// Work that one rank does for all.
#pragma once

#include <functional>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Does `action` on the first rank while the others wait; what it throws ends the run on all ranks with
/// "style: what". Every rank has to call it.
void on_first_rank(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::function<void()>& action);

/// A line on the screen and in the log.
void tell(LAMMPS_NS::LAMMPS& engine, const std::string& line);

/// The engine's own warning, from the first rank.
void warn(LAMMPS_NS::LAMMPS& engine, const std::string& text);

}  // namespace mikromakro::styles
