// SPDX-License-Identifier: GPL-2.0-or-later
// Fabric tensor (Latzel2001 Table 1).
#pragma once

#include "fields/volume_sum.h"

namespace mikromakro {

/// F = 1/V sum_p w^p V^p sum_c n^c (x) n^c, dimensionless (Latzel2001 Table 1 in Eq. 4).
class Fabric : public VolumeSum {
 public:
  std::string_view name() const override { return "fabric"; }
  std::vector<Column> columns(const Axes& axes) const override;
  bool needs_contacts() const override { return true; }
  int sums() const override { return 4; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
};

}  // namespace mikromakro
