// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/id_map.h"

#include <algorithm>

namespace mikromakro {
namespace {

// A table up to this many times the number of particles is still cheaper than a search.
constexpr std::int64_t densest_table = 8;

}  // namespace

IdMap::IdMap(const std::vector<Particle>& particles) {
  if (particles.empty()) return;
  const auto [low, high] = std::minmax_element(
      particles.begin(), particles.end(), [](const Particle& a, const Particle& b) { return a.id < b.id; });
  lowest_ = low->id;
  const std::int64_t range = high->id - lowest_ + 1;
  const int count = static_cast<int>(particles.size());
  if (range <= densest_table * count) {
    dense_.assign(static_cast<std::size_t>(range), -1);
    for (int i = 0; i < count; ++i) {
      int& index = dense_[static_cast<std::size_t>(particles[i].id - lowest_)];
      if (index >= 0 && duplicate_ < 0) duplicate_ = i;
      index = i;
    }
    return;
  }
  for (int i = 0; i < count; ++i) sorted_.push_back({particles[i].id, i});
  std::sort(sorted_.begin(), sorted_.end(),
            [](const Entry& a, const Entry& b) { return a.id != b.id ? a.id < b.id : a.index < b.index; });
  for (std::size_t i = 1; i < sorted_.size(); ++i) {
    if (sorted_[i].id == sorted_[i - 1].id && (duplicate_ < 0 || sorted_[i].index < duplicate_))
      duplicate_ = sorted_[i].index;
  }
}

int IdMap::search(std::int64_t id) const {
  const auto found =
      std::lower_bound(sorted_.begin(), sorted_.end(), id,
                       [](const Entry& entry, std::int64_t wanted) { return entry.id < wanted; });
  return found != sorted_.end() && found->id == id ? found->index : -1;
}

}  // namespace mikromakro
