// SPDX-License-Identifier: GPL-2.0-or-later
// What a restart file holds for fixes that the script does not define again.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// The walls of a style in a restart file; made with each fix of the style, between read_restart and the
/// first run after it, when the engine forgets them.
class WallsOfRestart {
 public:
  WallsOfRestart(const LAMMPS_NS::LAMMPS& engine, std::string style);

  /// Tells once, when a run begins, which of them no fix continues. Some engines do not.
  void tell_of_those_left(LAMMPS_NS::LAMMPS& engine);

 private:
  std::string style_;
  std::vector<std::string> names_;  // of fixes
};

}  // namespace mikromakro::styles
