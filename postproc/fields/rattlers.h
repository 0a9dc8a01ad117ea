// SPDX-License-Identifier: GPL-2.0-or-later
// Discs that carry no load.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Number fraction of discs with fewer than two contacts, since a single contact force cannot be balanced.
/// (The volume fractions are 1 - nu_m/nu, Latzel2001 Bild 4.) nan where there is no disc.
class Rattlers : public Field {
 public:
  std::string_view name() const override { return "rattler_fraction"; }
  std::vector<Column> columns(const Axes& axes) const override;
  bool needs_contacts() const override { return true; }
  int sums() const override { return 2; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
