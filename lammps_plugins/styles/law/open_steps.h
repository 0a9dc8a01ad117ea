// SPDX-License-Identifier: GPL-2.0-or-later
// Conditions for open steps (packed_discs.h), and the engine's work that they make unnecessary.
#pragma once

#include <vector>

#include "pointers.h"

namespace LAMMPS_NS {
class Fix;
}

namespace mikromakro::styles {

/// True if half-kicks may be fused: within a step nothing but the pair style, the integrator, and fixes on
/// rows (fix_on_rows.h) acts on discs or reads them. Anything else called within a step, unless known to
/// leave discs alone, forbids it. Fixes and computes that read or act only at the end of certain steps do not
/// matter in the others.
bool steps_may_be_open(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& integrator);

/// True if the engine will rebuild its neighbour lists in this step regardless of displacements.
bool build_is_due(LAMMPS_NS::LAMMPS& engine);

/// Steps at whose end velocities or forces are read.
class EndOfStepReaders {
 public:
  /// Call at the start of a run.
  void look_up(LAMMPS_NS::LAMMPS& engine);
  bool any_at_present_step(LAMMPS_NS::LAMMPS& engine) const;

 private:
  std::vector<int> intervals_;
};

/// Work that the engine is made to skip in one step: the integrator switches it off, and the disc law, whose
/// evaluation follows, switches it on again.
class SkippedWork {
 public:
  /// The displacement check of the neighbour lists, a search over all discs. A signal that arrives after this
  /// call and requires new lists waits for the next step.
  void skip_list_check(LAMMPS_NS::LAMMPS& engine);
  /// The clearing of forces and torques.
  void skip_clearing(LAMMPS_NS::LAMMPS& engine);
  void restore(LAMMPS_NS::LAMMPS& engine);

  /// True if the engine's forces were not cleared in the step of the last restore(). Asked once per step: the
  /// caller then overwrites them.
  bool take_stale_forces();

 private:
  bool list_check_ = false, clearing_ = false;  // switched off by us
  int asks_for_lists_ = 0;                      // saved value while switched off: see engine_access.h
  bool forces_are_stale_ = false;
};

}  // namespace mikromakro::styles
