// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/rotational_stiffness.h"

namespace mikromakro {

std::vector<Column> RotationalStiffness::columns(const Axes& /*axes*/) const {
  return {{"mu_c", "Pa", "Latzel2001 Bild 12", "rotational stiffness M.kappa/kappa.kappa"}};
}

void RotationalStiffness::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers,
                                RowsRef columns) const {
  const auto squared = numbers.col(2).square() + numbers.col(3).square();
  // 0/0 is nan, as intended.
  columns.col(0) = (numbers.col(0) * numbers.col(2) + numbers.col(1) * numbers.col(3)) / squared;
}

}  // namespace mikromakro
