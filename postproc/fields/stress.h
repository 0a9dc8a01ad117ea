// SPDX-License-Identifier: GPL-2.0-or-later
// Static part of the stress tensor (Latzel2001 Eq. 16).
#pragma once

#include "fields/volume_sum.h"

namespace mikromakro {

/// sigma = 1/V sum_p w^p sum_c f^c (x) l^pc, Pa (Latzel2001 Eq. 16). The force acts on p and the branch
/// vector points outward, so compression is negative. First index: direction of the force; second: of the
/// branch vector.
class Stress : public VolumeSum {
 public:
  std::string_view name() const override { return "stress"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::fx, ContactColumn::fy); }
  bool needs_contacts() const override { return true; }
  ContactPlace contact_place() const override { return ContactPlace::branch; }
  int sums() const override { return 4; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
};

}  // namespace mikromakro
