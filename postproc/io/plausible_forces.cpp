#include "io/plausible_forces.h"

#include <algorithm>

namespace mikromakro {

void note_forces(const std::vector<Contact>& contacts, const ContactRules& rules) {
  if (rules.notes == nullptr || contacts.empty()) return;
  double pushing = 0, all = 0;
  for (const Contact& contact : contacts) {
    pushing -= contact.force.dot(contact.normal);
    all += contact.force.norm();
  }
  if (all == 0)
    rules.notes->add("all forces are 0 though discs overlap (another column?)", rules.step,
                     std::ssize(contacts));
  constexpr std::size_t enough = 20;
  if (contacts.size() >= enough && pushing < 0.25 * all)
    rules.notes->add(
        "contacts pull on the whole, or their forces are across (ids or columns exchanged? forces on the "
        "other disc?); without cohesion they push",
        rules.step);
}

}  // namespace mikromakro
