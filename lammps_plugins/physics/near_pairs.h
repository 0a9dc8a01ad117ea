// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs of discs that may touch before the discs have moved by a small part of the neighbour list's skin,
// with their springs: what a pair loop goes through in every step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "physics/contact_batch.h"

namespace mikromakro::physics {

/// Gap [m] below which pairs are near: a pair that was further apart is not looked at again before two discs
/// may have come closer by as much. Results do not depend on it, times do. With v, how far the fastest disc
/// goes in a step [m], a look at all pairs is due every gap/2v steps and costs about two thirds of an
/// evaluation of those that touch (measured); pairs that are near without touching add about 0.55
/// sqrt(gap/skin) to each evaluation (measured in packings: 0.18 at gap/skin = 0.08, 0.24 at 0.21). The sum,
/// 4/3 v/gap + 0.55 sqrt(gap/skin), is least at gap^(3/2) = 4.85 v sqrt(skin).
inline double near_gap(double fastest_path, double skin) {
  return std::clamp(std::cbrt(23.5 * fastest_path * fastest_path * skin), skin / 100, skin);
}

/// Whether the gap between the discs is at most this.
[[gnu::always_inline]] inline bool are_near(const DiscRow& a, const DiscRow& b, double gap) {
  const Four d = b.place + sign_of_place * a.place;
  const double limit = d[2] + gap;
  return d[0] * d[0] + d[1] * d[1] <= limit * limit;
}

class NearPairs {
 public:
  /// Finds those of `all` that are near, and those that `touched` says yes of (empty: none of them). Without
  /// branches: which pairs are near cannot be foretold. `ahead`: so many pairs before their turn rows are
  /// fetched from memory (0: they are in the processor's cache).
  [[gnu::always_inline]] void find(const std::vector<DiscPair>& all, const DiscRow* discs,
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
  /// For laws with a spring, of each pair that was found.
  void set_spring(int k, bool touched, double xi, double slip_rate) {
    springs(k).xi[lane(k)] = xi;
    springs(k).slip_rate[lane(k)] = slip_rate;
    set_touched(k, touched);
  }

  int size() const { return static_cast<int>(pairs_.size()); }
  const DiscPair* from(int first) const { return &pairs_[first]; }
  /// The place of a pair among all.
  int number(int k) const { return numbers_[k]; }
  double xi(int k) const { return springs_[k / ContactBatch::lanes].xi[lane(k)]; }
  double slip_rate(int k) const { return springs_[k / ContactBatch::lanes].slip_rate[lane(k)]; }
  void set_touched(int k, bool touched) { springs(k).touched[lane(k)] = touched ? 1 : 0; }

  /// Springs of the batch that pair k is in.
  SpringLanes& springs(int k) { return springs_[k / ContactBatch::lanes]; }
  /// Fetches springs of `count` pairs from `first` on, one batch, from memory.
  void fetch_springs(int first, int count) {
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
