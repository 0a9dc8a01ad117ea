// SPDX-License-Identifier: GPL-2.0-or-later
// Mean velocity, from the flux nu v.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// v = (nu v) / nu with nu v = 1/V sum_p w^p V^p v^p (Latzel2001 Eq. 5), m/s. nan where there is no disc.
class Velocity : public Field {
 public:
  std::string_view name() const override { return "velocity"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet particles_needed() const override { return column_set(ParticleColumn::vx, ParticleColumn::vy); }
  int sums() const override { return 3; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const override;
};

}  // namespace mikromakro
