// SPDX-License-Identifier: GPL-2.0-or-later
// Force of the walls on the discs.
#pragma once

#include "fields/volume_sum.h"

namespace mikromakro {

/// t = 1/V sum of w(x_c) f^c over contacts c with walls and with discs that are not averaged, N/m^3: the
/// forces on the averaged discs, at the ends of the branches. This is the boundary interaction force density
/// of Weinhart2012. It closes the momentum balance where walls are within reach of a kernel: div sigma + t +
/// body forces = rate of momentum (div over the second index of sigma, kinetic stress included). With the
/// weights sliced and centre, contacts count where their discs do, and the sum is only the wall force on the
/// discs in V.
class WallForceDensity : public VolumeSum {
 public:
  std::string_view name() const override { return "wall_force_density"; }
  std::vector<Column> columns(const Axes& axes) const override;
  ColumnSet contacts_needed() const override { return column_set(ContactColumn::fx, ContactColumn::fy); }
  bool needs_contacts() const override { return true; }
  ContactPlace contact_place() const override { return ContactPlace::wall_point; }
  int sums() const override { return 2; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
};

}  // namespace mikromakro
