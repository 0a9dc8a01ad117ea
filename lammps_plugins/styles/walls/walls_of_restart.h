// SPDX-License-Identifier: GPL-2.0-or-later
// Walls in a restart file whose fixes the script does not define again.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// The walls of a style in a restart file. Constructed with each fix of the style, between read_restart and
/// the first run after it, when the engine discards them.
class WallsOfRestart {
 public:
  WallsOfRestart(const LAMMPS_NS::LAMMPS& engine, std::string style);

  /// Reports once, at the start of a run, the walls that no fix continues; some engines do not report this.
  void warn_of_unclaimed(LAMMPS_NS::LAMMPS& engine);

 private:
  std::string style_;
  std::vector<std::string> names_;  // of the fixes
};

}  // namespace mikromakro::styles
