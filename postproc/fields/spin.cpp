// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/spin.h"

namespace mikromakro {

std::vector<Column> Spin::columns(const Axes& /*axes*/) const {
  return {{"spin", "rad/s", "Latzel2001 Eq. 4", "mean angular velocity, counter-clockwise positive"}};
}

void Spin::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += disc.volume;
  quantity[1] += disc.volume * disc.spin;
}

void Spin::solve(const VolumeData& /*volumes*/, const ConstRowsRef& sums, RowsRef columns) const {
  columns.col(0) = sums.col(1) / sums.col(0);
}

}  // namespace mikromakro
