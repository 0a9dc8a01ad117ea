// SPDX-License-Identifier: GPL-2.0-or-later
// Fields that are sums over a volume by its measure.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Columns Q = 1/V times the mean sums, one each (Eq. 4). Such columns of small volumes add up, weighted with
/// V, to those of the volume that they fill.
class VolumeSum : public Field {
 public:
  bool is_volume_sum() const final { return true; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const final {
    columns = numbers.colwise() / volumes.measure;
  }
};

}  // namespace mikromakro
