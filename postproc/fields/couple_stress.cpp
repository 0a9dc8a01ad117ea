// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/couple_stress.h"

#include "fields/cross_product.h"

namespace mikromakro {

std::vector<Column> CoupleStress::columns(const Axes& axes) const {
  return {{"M_z" + axes[0], "N/m", "Latzel2001 Table 2", "couple stress"},
          {"M_z" + axes[1], "N/m", "Latzel2001 Table 2", "couple stress"}};
}

void CoupleStress::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                                std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    const double torque = cross(contact.branch, contact.force);
    quantity[0] += torque * contact.branch[0];
    quantity[1] += torque * contact.branch[1];
  }
}

}  // namespace mikromakro
