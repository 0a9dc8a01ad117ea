// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/stress.h"

namespace mikromakro {

std::vector<Column> Stress::columns(const Axes& axes) const {
  return tensor_columns("sigma", axes,
                        {"", "Pa", "Latzel2001 Eq. 16", "contact stress, compression negative"});
}

void Stress::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                          std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) add_dyad(contact.force, contact.branch, quantity);
}

}  // namespace mikromakro
