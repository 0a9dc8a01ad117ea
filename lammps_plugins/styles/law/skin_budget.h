// SPDX-License-Identifier: GPL-2.0-or-later
// Skin budget: how far discs may move and radii may grow before the neighbour lists are too old.
//
// The engine lists the pairs with a gap below the skin, so its lists are valid until two discs have
// approached by the skin; it rebuilds them when a disc may have moved by half the skin (the "trigger").
// Growing discs approach each other as if they moved, which the engine does not know: their growth reduces
// its trigger. The inner list (pair_lists.h) has a smaller budget of its own, the gap to which it is pruned.
#pragma once

#include <string>
#include <vector>

#include "law/packed_discs.h"
#include "physics/math/plane_vector.h"
#include "pointers.h"

namespace mikromakro::styles {

class SkinBudget : protected LAMMPS_NS::Pointers {
 public:
  explicit SkinBudget(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}

  /// Call at the start of a run. `style`: prefix of error messages. Collective.
  void begin_run(std::string style);
  /// Call once per run, after its set-up built the lists: radii may have grown during the set-up. Collective.
  void check_growth_in_set_up();
  /// Largest radius of each type [m], which the engine's neighbour lists are made for: over all ranks at the
  /// start of the run, including discs that fixes will insert.
  double largest_radius(int type) const { return largest_radii_[type]; }

  /// The engine has built its lists from these discs. Stops the run if discs have outgrown the distance that
  /// the engine searches for neighbours, or have no radius or mass.
  void lists_were_built(const std::vector<physics::DiscRow>& discs);
  /// The discs have changed since the last evaluation. Stops the run if a radius grows too fast.
  void spend(const DiscChange& change);
  /// Number of steps, including this one (whose rows must be up to date), within which no disc can move
  /// beyond half the skin of the neighbour list, provided none exceeds six times the current maximum speed.
  int steps_lists_stay_valid(const PackedDiscs& packed);

  /// The gap [m] to which the inner list is to be pruned now, from the speeds since it was last pruned.
  double begin_inner_list();
  bool inner_list_is_old() const { return 2 * inner_path_ > inner_gap_; }
  /// Number of steps for which the inner list stays valid at the present speed.
  int steps_inner_list_stays_valid(const PackedDiscs& packed) const;

 private:
  void find_largest_radii();
  double sum_of_radii() const;
  double excess_radius(int i) const;
  void follow_growth(double growth);
  void reduce_trigger(double by);

  std::string style_;
  // Since the lists were built: positions of the owned discs then, and upper bound on their displacement [m].
  std::vector<physics::PlaneVector> built_at_;
  double path_ = 0;
  // Radii [m]: see largest_radius(); excess over the radii that the present lists were made for; largest
  // growth in the last step.
  std::vector<double> largest_radii_;
  double excess_ = 0, growth_ = 0;
  double sum_of_radii_ = 0;      // of all discs, before the set-up [m]
  bool grew_in_set_up_ = false;  // the lists were built from smaller radii
  // Inner list, and since it was last pruned: upper bound on displacement plus growth of any disc [m], number
  // of steps.
  double inner_gap_ = 0, inner_path_ = 0;
  int inner_steps_ = 0;
  double fastest_path_ = 0;  // longest path per step, at recent speeds [m]
};

}  // namespace mikromakro::styles
