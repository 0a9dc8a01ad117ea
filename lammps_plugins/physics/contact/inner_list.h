// SPDX-License-Identifier: GPL-2.0-or-later
// Inner (pruned) Verlet list: the pairs that may touch before the discs have moved by a small part of the
// neighbour list's skin, with their tangential springs. The pair loop runs over this list in every step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "physics/contact/contact_batch.h"

namespace mikromakro::physics {

/// Cutoff gap [m] of the inner list: pairs with a wider gap are skipped until two discs may have approached
/// by that much. Affects speed only, never results. With v the path of the fastest disc per step [m], pruning
/// is due every gap/2v steps and costs about two thirds of an evaluation of the touching pairs (measured).
/// Listed pairs that do not touch add about 0.55 sqrt(gap/skin) to each evaluation (measured in packings:
/// 0.18 at gap/skin = 0.08, 0.24 at 0.21). The total cost, 4/3 v/gap + 0.55 sqrt(gap/skin), is minimal at
/// gap^(3/2) = 4.85 v sqrt(skin).
inline double inner_gap(double fastest_path, double skin) {
  return std::clamp(std::cbrt(23.5 * fastest_path * fastest_path * skin), skin / 100, skin);
}

/// True if the gap between the discs is at most `gap`.
[[gnu::always_inline]] inline bool are_near(const DiscRow& a, const DiscRow& b, double gap) {
  const Four d = b.place + sign_of_place * a.place;
  const double limit = d[2] + gap;
  return d[0] * d[0] + d[1] * d[1] <= limit * limit;
}

class InnerList {
 public:
  /// Takes from the list `all` the pairs within `gap` and those marked in `touched` (empty: none marked).
  /// Branch-free, since which pairs are near is unpredictable. `ahead`: prefetch distance in pairs (0: all
  /// data are already in cache).
  [[gnu::always_inline]] void prune(const std::vector<DiscPair>& all, const DiscRow* discs,
                                    const std::vector<char>& touched, double gap, std::size_t ahead = 0) {
    numbers_.resize(all.size());
    int count = 0;
    for (std::size_t n = 0; n < all.size(); ++n) {
      if (ahead > 0) __builtin_prefetch(&discs[all[std::min(n + ahead, all.size() - 1)].j]);
      numbers_[count] = static_cast<int>(n);
      const int near = are_near(discs[all[n].i], discs[all[n].j], gap) ? 1 : 0;
      count += touched.empty() ? near : near | touched[n];
    }
    numbers_.resize(count);
    pairs_.resize(count);
    for (int k = 0; k < count; ++k) pairs_[k] = all[numbers_[k]];
    if (!touched.empty()) springs_.resize((count + ContactBatch::lanes - 1) / ContactBatch::lanes);
  }
  /// Sets the tangential displacement xi [m] and slip rate [m/s] of pair k; for laws with a spring, call it
  /// for each pair found.
  void set_spring(int k, bool touched, double xi, double slip_rate) {
    springs(k).xi[lane(k)] = xi;
    springs(k).slip_rate[lane(k)] = slip_rate;
    set_touched(k, touched);
  }

  int size() const { return static_cast<int>(pairs_.size()); }
  const DiscPair* from(int first) const { return &pairs_[first]; }
  /// Index of pair k in the full list.
  int number(int k) const { return numbers_[k]; }
  double xi(int k) const { return springs_[k / ContactBatch::lanes].xi[lane(k)]; }
  double slip_rate(int k) const { return springs_[k / ContactBatch::lanes].slip_rate[lane(k)]; }
  void set_touched(int k, bool touched) { springs(k).touched[lane(k)] = touched ? 1 : 0; }

  /// Springs of the batch that contains pair k.
  SpringLanes& springs(int k) { return springs_[k / ContactBatch::lanes]; }
  /// Prefetches the springs of `count` pairs from `first` on, which must be in one batch.
  void prefetch_springs(int first, int count) {
    for (int k = 0; k < count; k += 8) {
      __builtin_prefetch(&springs(first).xi[k], 1);
      __builtin_prefetch(&springs(first).slip_rate[k], 1);
      __builtin_prefetch(&springs(first).touched[k]);
    }
  }

  std::size_t bytes() const {
    return pairs_.size() * (sizeof(DiscPair) + sizeof(int)) + springs_.size() * sizeof(SpringLanes);
  }

 private:
  static int lane(int k) { return k % ContactBatch::lanes; }

  std::vector<DiscPair> pairs_;
  std::vector<int> numbers_;
  std::vector<SpringLanes> springs_;
};

}  // namespace mikromakro::physics
