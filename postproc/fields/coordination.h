// SPDX-License-Identifier: GPL-2.0-or-later
// Volume-weighted coordination number.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// C = sum_p w^p V^p C^p / sum_p w^p V^p, with C^p the number of contacts of disc p, so that tr F = nu C
/// identically (Latzel2001 Eq. 10 with g_2 = 1). nan where there is no disc.
class Coordination : public Field {
 public:
  std::string_view name() const override { return "coordination"; }
  std::vector<Column> columns(const Axes& axes) const override;
  bool needs_contacts() const override { return true; }
  int sums() const override { return 2; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const override;
};

}  // namespace mikromakro
