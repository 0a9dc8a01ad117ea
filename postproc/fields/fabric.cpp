// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/fabric.h"

namespace mikromakro {

std::vector<Column> Fabric::columns(const Axes& axes) const {
  return tensor_columns("F", axes, {"", "1", "Latzel2001 Table 1", "fabric tensor"});
}

void Fabric::add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                          std::span<double> quantity) const {
  for (const DiscContact& contact : contacts)
    add_dyad(disc.volume * contact.normal, contact.normal, quantity);
}

}  // namespace mikromakro
