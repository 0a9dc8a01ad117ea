// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/velocity.h"

namespace mikromakro {

std::vector<Column> Velocity::columns(const Axes& axes) const {
  std::vector<Column> columns;
  for (const std::string& axis : axes)
    columns.push_back({"v_" + axis, "m/s", "Latzel2001 Eq. 5", "mean velocity"});
  return columns;
}

void Velocity::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += disc.volume;
  quantity[1] += disc.volume * disc.velocity[0];
  quantity[2] += disc.volume * disc.velocity[1];
}

void Velocity::solve(const VolumeData& /*volumes*/, const ConstRowsRef& sums, RowsRef columns) const {
  columns = sums.rightCols(2).colwise() / sums.col(0);
}

}  // namespace mikromakro
