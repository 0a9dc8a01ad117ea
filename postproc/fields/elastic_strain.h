// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic displacement gradient (Latzel2001 Eq. 20).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// eps = (sum_p w^p sum_c Delta (x) l) (sum_p w^p sum_c l (x) l)^-1, dimensionless: the least-squares fit of
/// eps l to the contact displacements Delta = delta n = -overlap n, over all contacts of all frames
/// (Latzel2001 Eqs. 17-20; with l = a_p n the second sum is V/(pi h) F). Compression is negative. The full
/// overlap counts, as in Latzel2001: isotropic compression gives eps = -overlap/a. nan where F is singular.
class ElasticStrain : public Field {
 public:
  std::string_view name() const override { return "elastic_strain"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::overlap); }
  bool needs_contacts() const override { return true; }
  ContactPlace contact_place() const override { return ContactPlace::branch; }
  int sums() const override;
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
