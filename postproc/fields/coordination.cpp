// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/coordination.h"

namespace mikromakro {

std::vector<Column> Coordination::columns(const Axes& /*axes*/) const {
  return {{"coordination", "1", "Latzel2001 Eq. 10", "contacts per disc, weighted by volume"}};
}

void Coordination::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += disc.volume;
  quantity[1] += disc.volume * disc.contacts;
}

void Coordination::solve(const VolumeData& /*volumes*/, const ConstRowsRef& sums, RowsRef columns) const {
  columns.col(0) = sums.col(1) / sums.col(0);
}

}  // namespace mikromakro
