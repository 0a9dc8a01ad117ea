// SPDX-License-Identifier: GPL-2.0-or-later
// Number-weighted coordination number.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// C = sum_p w^p C^p / sum_p w^p: mean number of contacts per disc, each disc weighted by its fraction in the
/// volume. This is the C of tr F = g_2 nu C (Latzel2001 Eq. 10). nan where there is no disc.
class NumberCoordination : public Field {
 public:
  std::string_view name() const override { return "coordination_number_averaged"; }
  std::vector<Column> columns(const Axes& axes) const override;
  bool needs_contacts() const override { return true; }
  int sums() const override { return 2; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
