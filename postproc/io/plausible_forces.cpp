#include "io/plausible_forces.h"

#include <algorithm>

namespace mikromakro {

void note_forces(const std::vector<Contact>& contacts, const ContactRules& rules) {
  if (rules.notes == nullptr || contacts.empty()) return;
  constexpr std::size_t enough = 64;
  const std::size_t stride = 1 + (contacts.size() - 1) / enough;
  double pushing = 0, all = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < contacts.size(); i += stride, ++count) {
    pushing -= contacts[i].force.dot(contacts[i].normal);
    all += contacts[i].force.norm();
  }
  const bool none = all == 0 && std::all_of(contacts.begin(), contacts.end(),
                                            [](const Contact& contact) { return contact.force.isZero(0); });
  if (none) rules.notes->add("all forces are 0 though discs overlap (another column?)", rules.step);
  constexpr std::size_t few = 5, many = 20;
  if (count >= few && all > 0 && pushing < (count < many ? -0.25 : 0.25) * all)
    rules.notes->add(
        "contacts pull on the whole, or their forces are across (ids or columns exchanged? forces on the "
        "other disc?); without cohesion they push",
        rules.step);
}

}  // namespace mikromakro
