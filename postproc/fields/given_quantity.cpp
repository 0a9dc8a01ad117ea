// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/given_quantity.h"

namespace mikromakro {

void GivenQuantity::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += disc.volume;
  for (std::size_t i = 1; i < quantity.size(); ++i) quantity[i] += disc.volume * disc.given[first_ + i - 1];
}

void GivenQuantity::solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const {
  const auto numbers = sums.rightCols(sums.cols() - 1);
  if (given_.over_discs)
    columns = numbers.colwise() / sums.col(0);
  else
    columns = numbers.colwise() / volumes.measure;
}

}  // namespace mikromakro
