// SPDX-License-Identifier: GPL-2.0-or-later
// The discs as rows side by side, shared by the pair style that evaluates contacts and the fixes that move
// discs.
//
// Between two time steps the final half-kick of one and the first half-kick of the next can be done in one go
// from the rows: forces are evaluated with velocities that were predicted for their instant, so nobody misses
// the velocities of the end of a step but those who look at them. The state is then "open": engine arrays
// hold neither velocities nor forces, and positions only of discs that have ghosts. It is closed wherever
// somebody looks, and never opened where anybody may act within a step.
#pragma once

#include <vector>

#include "lmptype.h"
#include "physics/disc_rows.h"
#include "pointers.h"

namespace LAMMPS_NS {
class Fix;
}

namespace mikromakro::styles {

struct PackedDiscs {
  std::vector<physics::DiscRow> discs;   // owned, then ghosts
  std::vector<physics::DiscLoad> loads;  // of the contacts
  bool may_stay_open = false;            // in this run; set by the fix that integrates
  bool open = false;                     // the loads of the last step are here and not in the engine
  LAMMPS_NS::bigint step = -1;           // in which rows of owned discs were written by those who move them
  double furthest = 0;                   // how far they moved a disc in that step at most [m]
  // Spared in this step: the engine's search for discs that left the skin, and its clearing of forces.
  bool check_is_off = false, clear_is_off = false;
  int asks_for_lists = 0;  // what the engine asks before it builds lists, while it is kept from asking
  // Pairs are to be looked through for near ones in this step: all ranks do so together, for one that does it
  // alone keeps the others waiting.
  bool look_is_due = false;

  /// Whether rows and loads had better be fetched from memory ahead of their use.
  bool exceed_cache() const { return physics::rows_exceed_cache(discs.size()); }
};

/// Whether nothing but the pair style, fix nve/disc (the integrator), fix couette/2d, fix biaxial/2d and fix
/// bottom/friction acts on discs or needs them within a step, so that the state may stay open. Nobody else is
/// known by name: what the engine calls within a step, and what is not known to leave discs alone, closes.
/// Fixes and computes that only look, or act, at the end of certain steps do no harm in the others.
bool may_stay_open(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& integrator);

/// Whether the engine is going to build its neighbour lists in this step, however far discs have moved.
bool build_is_due(LAMMPS_NS::LAMMPS& engine);

/// Tells the steps at the end of which somebody looks at velocities or forces.
class EndOfStepReaders {
 public:
  /// At the start of a run.
  void look_up(LAMMPS_NS::LAMMPS& engine);
  bool any_at_present_step(LAMMPS_NS::LAMMPS& engine) const;

 private:
  std::vector<int> intervals_;
};

}  // namespace mikromakro::styles
