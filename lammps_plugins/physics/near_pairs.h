// Pairs of discs that may touch before the discs have moved by a small part of the neighbour list's skin,
// with their springs: what a pair loop goes through in every step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "physics/contact_batch.h"

namespace mikromakro::physics {

/// A pair that was further apart than this fraction of the skin is not looked at again before two discs may
/// have come closer by as much. Results do not depend on it.
inline constexpr double near_fraction = 0.05;

class NearPairs {
 public:
  void clear() {
    pairs_.clear();
    numbers_.clear();
    xi_.clear();
    slip_rate_.clear();
    touched_.clear();
  }
  /// `number` tells the pair among all.
  void add(DiscPair pair, int number) {
    pairs_.push_back(pair);
    numbers_.push_back(number);
  }
  /// Of the pair that was added last, for laws with a spring.
  void add_spring(bool touched, double xi, double slip_rate) {
    xi_.push_back(xi);
    slip_rate_.push_back(slip_rate);
    touched_.push_back(touched ? 1 : 0);
  }

  int size() const { return static_cast<int>(pairs_.size()); }
  const DiscPair* from(int first) const { return &pairs_[first]; }
  int number(int k) const { return numbers_[k]; }
  double xi(int k) const { return xi_[k]; }
  double slip_rate(int k) const { return slip_rate_[k]; }
  void set_touched(int k, bool touched) { touched_[k] = touched ? 1 : 0; }

  /// Springs of `count` pairs from `first` on to the lanes and back.
  void load_springs(ContactBatch& c, int first, int count) const {
    std::memcpy(c.xi, &xi_[first], count * sizeof(double));
    std::memcpy(c.slip_rate, &slip_rate_[first], count * sizeof(double));
    std::memcpy(c.touched, &touched_[first], count * sizeof(std::int64_t));
    for (int k = count; k < padded(count); ++k) {
      c.xi[k] = c.slip_rate[k] = 0;
      c.touched[k] = c.touched[count - 1];
    }
  }
  void store_springs(const ContactBatch& c, int first, int count) {
    std::memcpy(&xi_[first], c.xi, count * sizeof(double));
    std::memcpy(&slip_rate_[first], c.slip_rate, count * sizeof(double));
  }

  std::size_t bytes() const {
    return pairs_.size() * (sizeof(DiscPair) + sizeof(int)) +
           xi_.size() * (2 * sizeof(double) + sizeof(std::int64_t));
  }

 private:
  std::vector<DiscPair> pairs_;
  std::vector<int> numbers_;
  std::vector<double> xi_, slip_rate_;
  std::vector<std::int64_t> touched_;
};

/// Whether the discs are closer than a fraction of the skin.
inline bool are_near(const DiscRow& a, const DiscRow& b, double gap) {
  const Four d = b.place + sign_of_place * a.place;
  const double limit = d[2] + gap;
  return d[0] * d[0] + d[1] * d[1] <= limit * limit;
}

}  // namespace mikromakro::physics
