// SPDX-License-Identifier: GPL-2.0-or-later
// Tangential springs at the smooth walls of a fix, stored per atom.
#pragma once

#include <array>
#include <vector>

#include "physics/walls/smooth_wall.h"

namespace mikromakro::styles {

/// Springs of touching discs only: an atom without any takes one index. Walls are identified by their id when
/// packed for another rank or a restart file, so that the walls of a continued run may be defined in another
/// order.
class WallSprings {
 public:
  static constexpr int most_walls = 4;

  void add_wall(int id) { ids_.push_back(id); }
  /// nullptr if atom i has no springs.
  physics::WallSpring* find(int i, int wall) {
    return slots_[i] == no_slot ? nullptr : &springs_[slots_[i]][wall];
  }
  physics::WallSpring* find_or_add(int i, int wall);
  /// Drops the springs of the first `nlocal` atoms that touch no wall, or may not (`may_touch(i)` is false).
  template <class MayTouch>
  void drop_unused(int nlocal, MayTouch may_touch);

  // Springs of atom i, for the engine's callbacks of the same names. Packed as: count, then wall id, xi [m]
  // and slip rate [m/s] of each.
  void grow(int nmax) { slots_.resize(nmax, no_slot); }
  void copy(int from, int to) { slots_[to] = slots_[from]; }
  void clear(int i) { slots_[i] = no_slot; }
  int packed_size(int i) const;
  int largest_packed_size() const { return 1 + 3 * static_cast<int>(ids_.size()); }
  static constexpr int largest_size = 1 + 3 * most_walls;
  int pack(int i, double* buffer) const;
  int unpack(int i, const double* buffer);
  double memory_usage() const;

 private:
  static constexpr int no_slot = -1;
  using OfDisc = std::array<physics::WallSpring, most_walls>;
  static bool any_touching(const OfDisc& springs);

  std::vector<int> ids_;         // of the walls
  std::vector<int> slots_;       // per atom: index into springs_
  std::vector<OfDisc> springs_;  // with unused ones, until drop_unused()
};

template <class MayTouch>
void WallSprings::drop_unused(int nlocal, MayTouch may_touch) {
  std::vector<OfDisc> used;
  for (int i = 0; i < nlocal; ++i) {
    if (slots_[i] == no_slot) continue;
    const OfDisc& springs = springs_[slots_[i]];
    const bool needed = may_touch(i) && any_touching(springs);
    slots_[i] = needed ? static_cast<int>(used.size()) : no_slot;
    if (needed) used.push_back(springs);
  }
  springs_.swap(used);
}

}  // namespace mikromakro::styles
