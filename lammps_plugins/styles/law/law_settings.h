// SPDX-License-Identifier: GPL-2.0-or-later
// Settings of the pair style: the laws and switches given in the script, and their record in restart files.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

class Arguments;

/// Read a pair style command with reset(), take() for each argument, then finish(). From then on, and after
/// read(), effects() is the combination of effects that the run simulates.
class LawSettings {
 public:
  const physics::Effects& effects() const { return effects_; }
  /// Fastest expected impact, for the time step check [m/s]; 0: not given.
  double impact_velocity() const { return impact_velocity_; }
  /// Without friction, contacts neither use nor change the spins of discs.
  bool has_friction() const { return effects_.tangential != physics::Tangential::none; }

  /// Back to the defaults: normal dashpot on, all other switches off.
  void reset(physics::Normal normal, physics::Tangential tangential);
  /// Reads a keyword and its value: damping, tangential_damping, limitForce, impact_velocity. Returns false,
  /// and takes nothing, if the next argument is none of these.
  bool take(Arguments& arguments);
  void set_tangential(physics::Tangential tangential) { effects_.tangential = tangential; }
  /// Combines the settings. Stops the run if they contradict each other.
  void finish(const Arguments& arguments);

  /// `key` identifies the pair style in the file. Call on the first rank only.
  void write(std::FILE* file, std::int64_t key) const;
  /// Collective; only the first rank reads `file`. Stops the run, with `style` as prefix of the message, if
  /// the record is incomplete, or from another pair style or another version.
  void read(LAMMPS_NS::LAMMPS& engine, const std::string& style, std::FILE* file, std::int64_t key);

 private:
  physics::Effects effects_;
  bool tangential_damping_ = false;
  double impact_velocity_ = 0;
};

}  // namespace mikromakro::styles
