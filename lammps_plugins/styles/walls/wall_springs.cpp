// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/wall_springs.h"

#include <algorithm>
#include <cstddef>

namespace mikromakro::styles {

using physics::WallSpring;

WallSpring* WallSprings::find_or_add(int i, int wall) {
  if (slots_[i] == no_slot) {
    slots_[i] = static_cast<int>(springs_.size());
    springs_.emplace_back();
  }
  return find(i, wall);
}

bool WallSprings::any_touching(const OfDisc& springs) {
  return std::any_of(springs.begin(), springs.end(), [](const WallSpring& s) { return s.touching; });
}

int WallSprings::packed_size(int i) const {
  if (slots_[i] == no_slot) return 1;
  const OfDisc& springs = springs_[slots_[i]];
  return 1 + 3 * static_cast<int>(std::count_if(springs.begin(), springs.end(),
                                                [](const WallSpring& s) { return s.touching; }));
}

int WallSprings::pack(int i, double* buffer) const {
  int size = 1;
  if (slots_[i] != no_slot) {
    const OfDisc& springs = springs_[slots_[i]];
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      if (!springs[k].touching) continue;
      buffer[size++] = ids_[k];
      buffer[size++] = springs[k].xi;
      buffer[size++] = springs[k].slip_rate;
    }
  }
  const int count = (size - 1) / 3;
  buffer[0] = count;
  return size;
}

int WallSprings::unpack(int i, const double* buffer) {
  slots_[i] = no_slot;
  const int count = static_cast<int>(buffer[0]);
  for (int k = 0; k < count; ++k) {
    const double* packed = buffer + 1 + 3 * k;
    for (std::size_t wall = 0; wall < ids_.size(); ++wall) {
      if (ids_[wall] == static_cast<int>(packed[0]))
        *find_or_add(i, static_cast<int>(wall)) = {packed[1], packed[2], true};
    }
  }
  return 1 + 3 * count;
}

double WallSprings::memory_usage() const {
  return static_cast<double>(slots_.size() * sizeof(int) + springs_.capacity() * sizeof(OfDisc));
}

}  // namespace mikromakro::styles
