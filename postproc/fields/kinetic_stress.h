// SPDX-License-Identifier: GPL-2.0-or-later
// Kinetic part of the stress tensor.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// sigma_kin = -1/V sum_p w^p m^p v' (x) v', Pa, with v' = v^p - u and u = sum w m v / sum w m, the mean
/// velocity of the volume over all frames; in terms of the sums, -1/V (sum w m v (x) v - (sum w m v) (x) u).
/// Latzel2001 omits this part (its section 3.4 takes the static part only). The variation of the mean
/// velocity within the volume counts as fluctuation. nan where there is no disc, and everywhere if the dump
/// has no masses.
class KineticStress : public Field {
 public:
  std::string_view name() const override { return "kinetic_stress"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet particles_needed() const override { return column_set(ParticleColumn::vx, ParticleColumn::vy); }
  int sums() const override { return 7; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const override;
  std::string note(const ConstRowsRef& sums) const override;
};

}  // namespace mikromakro
