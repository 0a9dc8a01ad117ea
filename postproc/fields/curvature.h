// SPDX-License-Identifier: GPL-2.0-or-later
// Curvature (Latzel2001 Table 2).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// kappa = (sum_p w^p sum_c (l x Delta) (x) l) (sum_p w^p sum_c l (x) l)^-1, m (Latzel2001 Table 2, with the
/// dimension given there): kappa_zr, kappa_zphi. The normal part of Delta has no moment about the centre. Its
/// tangential part is the displacement along the elastic tangential force on the disc: Delta_t = -xi t if the
/// law has a tangential spring (some xi in the dumps is not 0), else f_t/k_n. note() reports which was used.
/// nan where F is singular, and everywhere if neither the spring nor k_n is known.
class Curvature : public Field {
 public:
  explicit Curvature(double normal_stiffness) : normal_stiffness_(normal_stiffness) {}

  std::string_view name() const override { return "curvature"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::fx, ContactColumn::fy); }
  bool needs_contacts() const override { return true; }
  ContactPlace contact_place() const override { return ContactPlace::branch; }
  int sums() const override;
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
  std::string note(const ConstRowsRef& numbers) const override;

 private:
  double normal_stiffness_;
};

}  // namespace mikromakro
