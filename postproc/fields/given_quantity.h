// SPDX-License-Identifier: GPL-2.0-or-later
// Averages of values that the caller gives for each disc.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fields/field.h"

namespace mikromakro {

/// A field of the caller's own: one value Q^p per disc and column.
struct GivenField {
  std::string name;
  std::vector<Column> columns;
  bool over_discs = false;         ///< the mean over the discs, not over the volume
  ColumnSet particles_needed = 0;  ///< dump columns that the values are computed from
  ColumnSet contacts_needed = 0;
  bool needs_contacts = false;
};

/// Q = 1/V sum_p w^p V^p Q^p (Latzel2001 Eq. 4), or with `over_discs` the mean sum_p w^p V^p Q^p/sum_p w^p
/// V^p, nan without discs; each in the unit of Q^p.
class GivenQuantity : public Field {
 public:
  /// Disc::given holds the values of all such fields; those of this one begin at `first`.
  GivenQuantity(GivenField given, std::size_t first) : given_(std::move(given)), first_(first) {}

  std::string_view name() const override { return given_.name; }
  std::vector<Column> columns(const Axes& /*axes*/) const override { return given_.columns; }
  ColumnSet particles_needed() const override { return given_.particles_needed; }
  ColumnSet contacts_needed() const override { return given_.contacts_needed; }
  bool needs_contacts() const override { return given_.needs_contacts; }
  int sums() const override { return static_cast<int>(given_.columns.size()) + 1; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  bool is_volume_sum() const override { return !given_.over_discs; }
  void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const override;

 private:
  GivenField given_;
  std::size_t first_;
};

}  // namespace mikromakro
