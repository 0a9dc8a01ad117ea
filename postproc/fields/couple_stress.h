// SPDX-License-Identifier: GPL-2.0-or-later
// Couple stress (Latzel2001 Table 2).
#pragma once

#include "fields/volume_sum.h"

namespace mikromakro {

/// M = 1/V sum_p w^p sum_c (l x f) (x) l, N/m (Latzel2001 Table 2): M_zr, M_zphi.
class CoupleStress : public VolumeSum {
 public:
  std::string_view name() const override { return "couple_stress"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::fx, ContactColumn::fy); }
  bool needs_contacts() const override { return true; }
  ContactPlace contact_place() const override { return ContactPlace::branch; }
  int sums() const override { return 2; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
};

}  // namespace mikromakro
