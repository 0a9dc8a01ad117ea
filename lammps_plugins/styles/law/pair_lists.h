// SPDX-License-Identifier: GPL-2.0-or-later
// The pairs of discs that may touch: the engine's neighbour list as one flat list, and the inner (pruned)
// list that the pair loop runs over. Keeps the tangential displacements of both and the engine's contact
// history up to date with each other.
#pragma once

#include <cstddef>
#include <vector>

#include "physics/contact/contact_batch.h"
#include "physics/contact/inner_list.h"

namespace LAMMPS_NS {
class NeighList;
}

namespace mikromakro::styles {

/// Columns of the engine's contact history.
inline constexpr int history_xi = 0, history_slip_rate = 1, history_size = 2;

/// The engine's contact history arrays that accompany its neighbour list: for neighbour k of disc i, whether
/// the two touch, and its values from values[i] + stride k on.
struct ContactHistory {
  int** touching;
  double** values;
  int stride;
};

/// Valid after the first rebuild(). Pairs are indexed by their position in the flat list ("number") or in the
/// inner list.
class PairLists {
 public:
  /// Copies the engine's newly built neighbour list. `history`: nullptr for laws without a spring.
  void rebuild(const LAMMPS_NS::NeighList& list, int nlocal, const ContactHistory* history);
  bool are_built() const { return built_; }
  /// Rebuilds the inner list: prunes all pairs to those whose gap is at most `gap` [m] and those in contact.
  /// `prefetch`: the discs exceed the cache.
  void prune(const std::vector<physics::DiscRow>& discs, double gap, bool prefetch);

  const std::vector<physics::DiscPair>& pairs() const { return pairs_; }
  physics::InnerList& inner() { return inner_; }
  /// True if pairs are sorted by their first disc i, and i < j: no pair involves a disc before the first disc
  /// of an earlier pair.
  bool are_sorted() const { return sorted_; }
  /// The engine's history of pair k of the inner list; nullptr for laws without a spring.
  double* history_of(int k) { return histories_.empty() ? nullptr : histories_[inner_.number(k)]; }
  /// Current number of touching pairs on this rank.
  std::size_t contacts(const std::vector<physics::DiscRow>& discs) const;

  /// Pair k of the inner list begins or ends its contact, with zero tangential displacement; slip rate [m/s].
  void change_contact(int k, bool touches, double slip_rate);
  /// The displacements of the inner list have changed and are not yet in the engine's history.
  void displacements_changed() { history_is_behind_ = true; }
  /// Writes them to the engine's history.
  void write_history();

  /// Memory of the lists, in this class and in the engine's contact history.
  std::size_t bytes() const;
  std::size_t bytes_in_engine() const;

 private:
  bool built_ = false, sorted_ = false;
  std::vector<physics::DiscPair> pairs_;
  std::vector<int> first_pair_;  // number of the first pair of each owned disc
  // For laws with a spring, otherwise empty: the engine's contact flags and histories, and which pairs
  // touched in the last step.
  int** flags_ = nullptr;
  std::vector<double*> histories_;
  std::vector<char> in_contact_;
  physics::InnerList inner_;
  bool history_is_behind_ = false;
};

}  // namespace mikromakro::styles
