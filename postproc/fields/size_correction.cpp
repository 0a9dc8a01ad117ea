// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/size_correction.h"

#include <cmath>
#include <numbers>

namespace mikromakro {

std::vector<Column> SizeCorrection::columns(const Axes& /*axes*/) const {
  return {{"g2", "1", "Latzel2001 Eq. 10", "<a^2/Omega>/(<a^2><1/Omega>)"},
          {"g2_linear", "1", "Latzel2001 Eq. 10", "its linear form, from <a>, <a^2>, <a^3>"}};
}

void SizeCorrection::add_disc(const Disc& disc, std::span<double> quantity) const {
  const double a = disc.radius;
  const double covered = 2 * std::asin(disc.mean_radius / (disc.mean_radius + a));
  quantity[0] += 1;
  quantity[1] += a;
  quantity[2] += a * a;
  quantity[3] += a * a * a;
  quantity[4] += 1 / covered;
  quantity[5] += a * a / covered;
}

void SizeCorrection::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers,
                           RowsRef columns) const {
  const auto count = numbers.col(0);
  columns.col(0) = numbers.col(5) * count / (numbers.col(2) * numbers.col(4));
  const auto skew = numbers.col(3) * count / (numbers.col(1) * numbers.col(2));
  columns.col(1) = 1 + std::numbers::sqrt3 / std::numbers::pi * (skew - 1);
}

}  // namespace mikromakro
