// SPDX-License-Identifier: GPL-2.0-or-later
// The volumes in which a position counts, with its share in each.
#pragma once

#include <cstddef>
#include <vector>

namespace mikromakro {

/// Share of a disc, a point or a branch in one volume.
struct Share {
  int volume;
  double weight;
};

/// Shares, each volume once, in order of first occurrence. clear() keeps the memory.
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

  /// For appending volumes that are not yet in the list, each once, which needs no summation. Not to be mixed
  /// with add().
  std::vector<Share>& list() { return list_; }
  const std::vector<Share>& list() const { return list_; }

 private:
  std::vector<Share> list_;
  std::vector<std::size_t> places_;  // by volume, index in the list plus one; 0: not in the list
};

}  // namespace mikromakro
