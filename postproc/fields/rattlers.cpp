// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/rattlers.h"

namespace mikromakro {

std::vector<Column> Rattlers::columns(const Axes& /*axes*/) const {
  return {{"rattler_fraction", "1", "-", "fraction of the discs, by number, with fewer than 2 contacts"}};
}

void Rattlers::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += 1;
  if (disc.contacts < 2) quantity[1] += 1;
}

void Rattlers::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers, RowsRef columns) const {
  columns.col(0) = numbers.col(1) / numbers.col(0);
}

}  // namespace mikromakro
