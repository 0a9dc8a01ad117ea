// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/wall_force_density.h"

namespace mikromakro {

std::vector<Column> WallForceDensity::columns(const Axes& axes) const {
  std::vector<Column> columns;
  for (const std::string& axis : axes) {
    columns.push_back({"wall_force_density_" + axis, "N/m^3", "Weinhart et al. 2012",
                       "force of walls and wall discs on the discs"});
  }
  return columns;
}

void WallForceDensity::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                                    std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    if (!contact.with_wall) continue;
    quantity[0] += contact.force[0];
    quantity[1] += contact.force[1];
  }
}

}  // namespace mikromakro
