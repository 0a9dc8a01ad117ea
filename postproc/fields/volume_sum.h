// SPDX-License-Identifier: GPL-2.0-or-later
// Fields that are sums over a volume divided by its measure.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Columns Q = 1/V times the mean sums, one to one (Eq. 4). Weighted with V, such columns of small volumes
/// add up to those of the larger volume that they fill.
class VolumeSum : public Field {
 public:
  bool is_volume_sum() const final { return true; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const final {
    columns = numbers.colwise() / volumes.measure;
  }
};

}  // namespace mikromakro
