#include "fields/stress.h"

namespace mikromakro {

std::vector<Column> Stress::columns(const Axes& axes) const {
  return tensor_columns("sigma", axes, {"", "Pa", "seed Eq. 16", "contact stress, compression negative"});
}

void Stress::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                          std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) add_dyad(contact.force, contact.branch, quantity);
}

}  // namespace mikromakro
