// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/solid_fraction.h"

#include <cmath>

namespace mikromakro {

std::vector<Column> SolidFraction::columns(const Axes& /*axes*/) const {
  return {{"nu", "1", "Latzel2001 Eq. 3", "solid fraction of all averaged discs"},
          {"nu_1", "1", "Latzel2001 Eq. 3", "solid fraction of discs with at least 1 contact"},
          {"nu_2", "1", "Latzel2001 Eq. 3", "solid fraction of discs with at least 2 contacts"},
          {"nu_3", "1", "Latzel2001 Eq. 3", "solid fraction of discs with at least 3 contacts"}};
}

void SolidFraction::add_disc(const Disc& disc, std::span<double> quantity) const {
  quantity[0] += disc.volume;
  for (int least = 1; least < sums(); ++least) {
    double& sum = quantity[static_cast<std::size_t>(least)];
    if (disc.contacts == Disc::unknown) sum = std::nan("");
    if (disc.contacts >= least) sum += disc.volume;
  }
}

}  // namespace mikromakro
