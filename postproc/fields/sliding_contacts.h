// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts at the Coulomb limit.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Number fraction of the contacts with |f_t| >= mu |f_n| and f_t not 0; each contact is weighted by the
/// fraction of each of its discs in the volume. The comparison allows for 1e-4 mu |f_n|, the precision of
/// text dumps whose normals follow from places of six digits. nan where there is no contact.
class SlidingContacts : public Field {
 public:
  explicit SlidingContacts(double friction_coefficient) : friction_(friction_coefficient) {}

  std::string_view name() const override { return "sliding_fraction"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::string_view missing_option() const override { return friction_ > 0 ? "" : "--mu"; }
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::fx, ContactColumn::fy); }
  bool needs_contacts() const override { return true; }
  int sums() const override { return 2; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  double friction_;
};

}  // namespace mikromakro
