#include "io/plausible_forces.h"

#include <algorithm>

namespace mikromakro {

void note_overlaps_of_contacts(const std::vector<Particle>& particles, const std::vector<Contact>& contacts,
                               const ContactRules& rules) {
  if (rules.notes == nullptr) return;
  constexpr double most = 0.5;  // radii
  const auto radius = [&](int index) { return particles[static_cast<std::size_t>(index)].radius; };
  const auto deep = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    const double one = radius(contact.index1);
    const double smaller = contact.with_wall() ? one : std::min(one, radius(contact.index2));
    return contact.overlap > most * smaller;
  });
  if (deep > 0)
    rules.notes->add(
        "contacts overlap by more than half of the smaller radius (k_n too small for the load, or a density "
        "in kg/m^3 where rho h in kg/m^2 was meant?)",
        rules.step, deep);
}

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
