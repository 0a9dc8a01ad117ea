// SPDX-License-Identifier: GPL-2.0-or-later
// Solid fraction nu (Latzel2001 Eq. 3), and nu_1, nu_2, nu_3 of the discs with at least 1, 2, 3 contacts
// (Latzel2001 Bild 4).
#pragma once

#include "fields/volume_sum.h"

namespace mikromakro {

/// nu = 1/V sum_p w^p V^p, dimensionless; nu_m is the same sum over the discs with m or more contacts, nan if
/// contacts are not known.
class SolidFraction : public VolumeSum {
 public:
  std::string_view name() const override { return "solid_fraction"; }
  std::vector<Column> columns(const Axes& axes) const override;
  int sums() const override { return 4; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
};

}  // namespace mikromakro
