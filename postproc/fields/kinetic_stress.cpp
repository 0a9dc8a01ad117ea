// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/kinetic_stress.h"

namespace mikromakro {

std::vector<Column> KineticStress::columns(const Axes& axes) const {
  return tensor_columns("sigma_kin", axes, {"", "Pa", "-", "kinetic stress, compression negative"});
}

void KineticStress::add_disc(const Disc& disc, std::span<double> quantity) const {
  const Eigen::Vector2d momentum = disc.mass * disc.velocity;
  quantity[0] += disc.mass;
  quantity[1] += momentum[0];
  quantity[2] += momentum[1];
  add_dyad(momentum, disc.velocity, quantity.subspan(3));
}

void KineticStress::solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const {
  for (Eigen::Index row = 0; row < 2; ++row) {
    for (Eigen::Index column = 0; column < 2; ++column) {
      const Eigen::Index dyad = 2 * row + column;
      const auto mean_part = sums.col(1 + row) * sums.col(1 + column) / sums.col(0);
      columns.col(dyad) = -(sums.col(3 + dyad) - mean_part) / volumes.measure;
    }
  }
}

std::string KineticStress::note(const ConstRowsRef& sums) const {
  const bool without = sums.rows() > 0 && sums.col(0).array().isNaN().any();
  return without ? "kinetic stress: masses are missing in some frames (--density gives them), not defined"
                 : "";
}

}  // namespace mikromakro
