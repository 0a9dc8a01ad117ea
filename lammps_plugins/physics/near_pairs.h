// Pairs of discs that may touch before the discs have moved by a small part of the neighbour list's skin,
// with their springs: what a pair loop goes through in every step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
    if (touched.empty()) return;
    xi_.resize(count);
    slip_rate_.resize(count);
    touched_.resize(count);
  }
  /// For laws with a spring, of each pair that was found.
  void set_spring(int k, bool touched, double xi, double slip_rate) {
    xi_[k] = xi;
    slip_rate_[k] = slip_rate;
    touched_[k] = touched ? 1 : 0;
  }

  int size() const { return static_cast<int>(pairs_.size()); }
  const DiscPair* from(int first) const { return &pairs_[first]; }
  /// The place of a pair among all.
  int number(int k) const { return numbers_[k]; }
  double xi(int k) const { return xi_[k]; }
  double slip_rate(int k) const { return slip_rate_[k]; }
  void set_touched(int k, bool touched) { touched_[k] = touched ? 1 : 0; }

  /// Springs of `count` pairs from `first` on to the lanes and back.
  void load_springs(ContactBatch& c, int first, int count) const {
    copy(c.xi, &xi_[first], count);
    copy(c.slip_rate, &slip_rate_[first], count);
    copy(c.touched, &touched_[first], count);
    for (int k = count; k < padded(count); ++k) {
      c.xi[k] = c.slip_rate[k] = 0;
      c.touched[k] = c.touched[count - 1];
    }
  }
  /// Fetches springs of `count` pairs from `first` on from memory.
  void fetch_springs(int first, int count) const {
    for (int k = 0; k < count; k += 8) {
      __builtin_prefetch(&xi_[first + k], 1);
      __builtin_prefetch(&slip_rate_[first + k], 1);
      __builtin_prefetch(&touched_[first + k]);
    }
  }
  void store_springs(const ContactBatch& c, int first, int count) {
    copy(&xi_[first], c.xi, count);
    copy(&slip_rate_[first], c.slip_rate, count);
  }

  std::size_t bytes() const {
    return pairs_.size() * (sizeof(DiscPair) + sizeof(int)) +
           xi_.size() * (2 * sizeof(double) + sizeof(std::int64_t));
  }

 private:
  /// By vectors: for so few numbers a string instruction, which compilers choose, takes longer to begin.
  template <typename Number>
  static void copy(Number* to, const Number* from, int count) {
    int k = 0;
    for (; k + 4 <= count; k += 4) {
      Four four;
      std::memcpy(&four, from + k, sizeof four);
      std::memcpy(to + k, &four, sizeof four);
    }
    for (; k < count; ++k) to[k] = from[k];
  }

  std::vector<DiscPair> pairs_;
  std::vector<int> numbers_;
  std::vector<double> xi_, slip_rate_;
  std::vector<std::int64_t> touched_;
};

}  // namespace mikromakro::physics
