// SPDX-License-Identifier: GPL-2.0-or-later
// A value for each pair of atom types.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mikromakro::styles {

/// Types are counted from 1, as in scripts. The table need not be symmetric.
template <class T>
class TypePairTable {
 public:
  TypePairTable() = default;
  explicit TypePairTable(int types)
      : types_(types), values_(static_cast<std::size_t>(types) * static_cast<std::size_t>(types)) {}

  int types() const { return types_; }
  T& operator()(int type_1, int type_2) { return values_[index(type_1, type_2)]; }
  const T& operator()(int type_1, int type_2) const { return values_[index(type_1, type_2)]; }

  /// True if all pairs of types have the same value.
  bool is_uniform() const {
    return std::all_of(values_.begin(), values_.end(), [this](const T& v) { return v == values_.front(); });
  }

  /// Row by row: types 1 1, 1 2, ...
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }

 private:
  std::size_t index(int type_1, int type_2) const {
    return static_cast<std::size_t>(type_1 - 1) * static_cast<std::size_t>(types_) +
           static_cast<std::size_t>(type_2 - 1);
  }

  int types_ = 0;
  std::vector<T> values_;
};

}  // namespace mikromakro::styles
