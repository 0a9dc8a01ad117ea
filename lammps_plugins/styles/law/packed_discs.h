// SPDX-License-Identifier: GPL-2.0-or-later
// Packed disc data, shared by the pair style, which evaluates contacts, and the fixes that move discs.
//
// The final half-kick of a step and the first half-kick of the next can be fused and done from the packed
// data: forces use predicted velocities, so end-of-step velocities are needed by output only; the step is
// closed when something reads them. With fused half-kicks the state is "open": engine arrays hold neither
// velocities nor forces, and positions only of discs that have ghosts. The state is never opened if anything
// other than our own fixes may act on discs within a step: see may_stay_open().
#pragma once

#include <vector>

#include "lmptype.h"
#include "physics/rows/disc_rows.h"
#include "pointers.h"

namespace LAMMPS_NS {
class Fix;
}

namespace mikromakro::styles {

struct PackedDiscs {
  std::vector<physics::DiscRow> discs;   // owned, then ghosts
  std::vector<physics::DiscLoad> loads;  // sums over contacts
  bool may_stay_open = false;            // in this run; set by the integrator
  bool open = false;                     // the last step's loads are here, not in the engine
  LAMMPS_NS::bigint step = -1;           // step in which movers wrote the rows of owned discs
  double furthest = 0;                   // largest displacement in that step [m]
  // Switched off in this step: the engine's displacement check of the neighbour list, and its clearing of
  // forces.
  bool check_is_off = false, clear_is_off = false;
  int asks_for_lists = 0;  // saved value while switched off: see asks_for_lists()
  // The inner list is to be pruned in this step. All ranks prune in the same step, since a rank pruning alone
  // would keep the others waiting.
  bool look_is_due = false;

  /// True if prefetching rows and loads pays.
  bool exceed_cache() const { return physics::rows_exceed_cache(discs.size()); }
};

/// True if half-kicks may be fused: within a step nothing but the pair style, the integrator, and fixes on
/// rows (fix_on_rows.h) acts on discs or reads them. Anything else called within a step, unless known to
/// leave discs alone, forbids it. Fixes and computes that read or act only at the end of certain steps do not
/// matter in the others.
bool may_stay_open(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& integrator);

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

}  // namespace mikromakro::styles
