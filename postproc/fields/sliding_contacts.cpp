// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/sliding_contacts.h"

#include <cmath>

namespace mikromakro {
namespace {

// Forces of six digits, turned by the error of normals from places of six digits.
constexpr double digits_of_dumps = 1e-4;

}  // namespace

std::vector<Column> SlidingContacts::columns(const Axes& /*axes*/) const {
  return {{"sliding_fraction", "1", "-", "fraction of the contacts with abs(f_t) = mu abs(f_n)"}};
}

void SlidingContacts::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                                   std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    const double tangential = std::abs(contact.force.dot(contact.tangent()));
    const double limit = friction_ * std::abs(contact.force.dot(contact.normal));
    quantity[0] += 1;
    if (tangential > 0 && tangential >= (1 - digits_of_dumps) * limit) quantity[1] += 1;
  }
}

void SlidingContacts::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers,
                            RowsRef columns) const {
  columns.col(0) = numbers.col(1) / numbers.col(0);
}

}  // namespace mikromakro
