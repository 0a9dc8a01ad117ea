// SPDX-License-Identifier: GPL-2.0-or-later
// Mean angular velocity of the discs.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// omega = sum_p w^p V^p omega^p / sum_p w^p V^p (Latzel2001 Eq. 4 with Q^p = omega^p; section 3.7), rad/s.
/// nan where there is no disc.
class Spin : public Field {
 public:
  std::string_view name() const override { return "spin"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet particles_needed() const override { return column_set(ParticleColumn::omegaz); }
  int sums() const override { return 2; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const override;
};

}  // namespace mikromakro
