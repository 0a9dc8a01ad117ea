// SPDX-License-Identifier: GPL-2.0-or-later
// Packed disc data: rows and loads, shared by the pair style, which evaluates contacts, and the fixes that
// move discs; and the copies from and to the engine's arrays.
//
// The final half-kick of a step and the first half-kick of the next can be fused and done from the packed
// data: forces use predicted velocities, so end-of-step velocities are needed by output only; the step is
// closed when something reads them. With fused half-kicks the step is "open": engine arrays hold neither
// velocities nor forces, and positions only of discs that have ghosts. No step is open if anything other than
// our own fixes may act on discs within it: see open_steps.h.
#pragma once

#include <vector>

#include "lmptype.h"
#include "physics/rows/disc_rows.h"

namespace LAMMPS_NS {
class Atom;
}

namespace mikromakro::styles {

/// Upper bounds, over all discs, on displacement and radius growth since the previous evaluation [m].
struct DiscChange {
  double moved, growth;
};

struct PackedDiscs {
  std::vector<physics::DiscRow> discs;   // owned, then ghosts
  std::vector<physics::DiscLoad> loads;  // sums over contacts
  bool may_be_open = false;              // in this run; set by the integrator
  bool open = false;                     // the last step's loads are here, not in the engine
  LAMMPS_NS::bigint step = -1;           // step in which movers wrote the rows of owned discs
  double furthest = 0;                   // largest displacement in that step [m]
  // The inner list is to be pruned in this step. All ranks prune in the same step, since a rank pruning alone
  // would keep the others waiting.
  bool prune_is_due = false;

  /// True if prefetching rows and loads pays.
  bool exceed_cache() const { return physics::rows_exceed_cache(discs.size()); }

  /// Packs the discs, owned or ghost, from index `first` on. `spins`: with their spins, otherwise 0. The
  /// returned change is meaningful only if indices are unchanged.
  DiscChange pack(const LAMMPS_NS::Atom& atom, int first, bool spins);
  /// Writes position and velocity of an owned disc, or of all, to the engine's arrays.
  void unpack(LAMMPS_NS::Atom& atom, int i, bool spins) const;
  void unpack_owned(LAMMPS_NS::Atom& atom, bool spins) const;
  /// Adds the loads of the owned discs to the engine's forces and torques, and clears them for the next step.
  /// `overwrite`: the engine has not cleared its forces in this step.
  void unload(LAMMPS_NS::Atom& atom, bool spins, bool overwrite);
};

}  // namespace mikromakro::styles
