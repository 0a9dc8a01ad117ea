// SPDX-License-Identifier: GPL-2.0-or-later
// The volumes in which a place counts, with their shares.
#pragma once

#include <cstddef>
#include <vector>

namespace mikromakro {

/// Share of a disc, a point or a branch in one volume.
struct Share {
  int volume;
  double weight;
};

/// Shares, each volume once, in the order in which the volumes came. Memory is used again after clear().
class ShareSums {
 public:
  void clear() {
    if (!places_.empty())
      for (const Share& share : list_) places_[static_cast<std::size_t>(share.volume)] = 0;
    list_.clear();
  }

  /// Adds to the volume's share.
  void add(int volume, double weight) {
    const auto index = static_cast<std::size_t>(volume);
    if (index >= places_.size()) places_.resize(2 * index + 1, 0);
    std::size_t& place = places_[index];
    if (place > 0) {
      list_[place - 1].weight += weight;
    } else {
      list_.push_back({volume, weight});
      place = list_.size();
    }
  }

  /// To append volumes that are not yet in it, each once: no sums are needed then. Not to be mixed with
  /// add().
  std::vector<Share>& list() { return list_; }
  const std::vector<Share>& list() const { return list_; }

 private:
  std::vector<Share> list_;
  std::vector<std::size_t> places_;  // by volume, one more than in the list; 0: not there
};

}  // namespace mikromakro
