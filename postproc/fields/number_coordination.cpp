// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/number_coordination.h"

namespace mikromakro {

std::vector<Column> NumberCoordination::columns(const Axes& /*axes*/) const {
  return {
      {"coordination_number_averaged", "1", "Latzel2001 Eq. 10", "contacts per disc, weighted by number"}};
}

void NumberCoordination::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += 1;
  quantity[1] += disc.contacts;
}

void NumberCoordination::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers,
                               RowsRef columns) const {
  columns.col(0) = numbers.col(1) / numbers.col(0);
}

}  // namespace mikromakro
