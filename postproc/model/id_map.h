// SPDX-License-Identifier: GPL-2.0-or-later
// Maps particle ids to indices in the frame; ids may have gaps and come in any order.
#pragma once

#include <cstdint>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

class IdMap {
 public:
  explicit IdMap(const std::vector<Particle>& particles);

  /// Index of the particle, -1 if no particle has this id.
  int find(std::int64_t id) const {
    const std::int64_t offset = id - lowest_;
    if (dense_.empty()) return search(id);
    return offset >= 0 && offset < std::ssize(dense_) ? dense_[static_cast<std::size_t>(offset)] : -1;
  }

  /// Index of the first particle that repeats an earlier id, -1 if all ids differ.
  int duplicate() const { return duplicate_; }

 private:
  int search(std::int64_t id) const;

  struct Entry {
    std::int64_t id;
    int index;
  };
  std::int64_t lowest_ = 0;
  std::vector<int> dense_;     ///< index by id - lowest_, if ids are dense enough
  std::vector<Entry> sorted_;  ///< otherwise, for binary search
  int duplicate_ = -1;
};

}  // namespace mikromakro
