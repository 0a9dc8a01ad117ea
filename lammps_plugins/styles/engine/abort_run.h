// SPDX-License-Identifier: GPL-2.0-or-later
// Errors that are found on one rank only.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Ends the run from this rank alone with "ERROR: style: what" on stderr and in the log. The engine's own
/// Error::one prints on the first rank only, and its message is lost if the output is a pipe.
[[noreturn]] void abort_run(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what);

}  // namespace mikromakro::styles
