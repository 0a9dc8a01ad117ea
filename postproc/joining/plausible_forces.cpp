// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/plausible_forces.h"

#include <algorithm>

#include "joining/contact_tolerance.h"

namespace mikromakro {

namespace {

// Sums over a sample of contacts.
struct Push {
  double pushing = 0;  // sum f_n
  double all = 0;      // sum |f|
  std::size_t count = 0;

  static constexpr std::size_t few = 5, many = 20;
  double mean() const { return all / static_cast<double>(count); }
  bool is_none() const { return count >= few && all > 0 && pushing < (count < many ? -0.25 : 0.25) * all; }
};

Push push_of(const std::vector<Contact>& contacts, std::size_t stride, bool of_walls) {
  Push push;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    if (contacts[i].with_wall() != of_walls) continue;
    ++push.count;
    push.pushing -= contacts[i].force.dot(contacts[i].normal);
    push.all += contacts[i].force.norm();
  }
  return push;
}

}  // namespace

void note_forces(const std::vector<Contact>& contacts, const ContactRules& rules) {
  if (rules.notes == nullptr || contacts.empty()) return;
  constexpr std::size_t enough = 64;
  const Push some = push_of(contacts, 1 + (contacts.size() - 1) / enough, false);
  const bool none =
      some.all == 0 && std::all_of(contacts.begin(), contacts.end(),
                                   [](const Contact& contact) { return contact.force.isZero(0); });
  rules.notes->judge("all forces are 0 though discs overlap (another column?)", none, rules.step);
  // A few collisions may carry most of the force, so the sample need not be representative.
  const bool pull = some.is_none() && push_of(contacts, 1, false).is_none();
  constexpr const char* text =
      "contacts are attractive on average, or their forces are mostly tangential (ids or columns swapped? "
      "forces on the other disc?); without cohesion or strong dashpots they repel";
  // Few discs may all be rebounding.
  if (some.count >= Push::many) {
    if (pull) rules.notes->add(text, rules.step);
  } else {
    rules.notes->judge(text, pull, rules.step);
  }
}

void note_wall_forces(const std::vector<Contact>& contacts, const ContactRules& rules) {
  if (rules.notes == nullptr || contacts.empty()) return;
  const Push walls = push_of(contacts, 1, true);
  if (walls.count < Push::few) return;
  rules.notes->judge("all forces of walls are 0 though discs touch them (another column?)", walls.all == 0,
                     rules.step);
  constexpr std::size_t enough = 64;
  constexpr double most = 300;
  const Push pairs = push_of(contacts, 1 + (contacts.size() - 1) / enough, false);
  rules.notes->judge(
      "forces of walls are hundreds of times those of pairs of discs, on average (another unit?)",
      pairs.count >= Push::few && pairs.all > 0 && walls.mean() > most * pairs.mean(), rules.step);
  rules.notes->judge(
      "walls are attractive on average, or their forces are mostly tangential (forces on the wall? columns "
      "swapped?); the force must be that on the disc, and without adhesion walls repel",
      walls.is_none(), rules.step);
}

void note_derived_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts,
                           const ContactRules& rules) {
  constexpr ColumnSet told = column_set(ContactColumn::overlap, ContactColumn::dist);
  const bool needed = (raw.contacts.needed & column_set(ContactColumn::overlap)) != 0;
  if (rules.notes == nullptr || !needed || (raw.contacts.given_in_all() & told) != 0) return;
  const bool by_row = (raw.contacts.given_in_all() & column_set(ContactColumn::x1)) != 0;
  const ContactTolerance tolerance(raw.contacts, raw.particles, raw.box, raw.place_error);
  double overlaps = 0, lost = 0;
  for (const Contact& contact : contacts) {
    if (contact.with_wall()) continue;
    const double one = raw.particles[static_cast<std::size_t>(contact.index1)].radius;
    const double two = raw.particles[static_cast<std::size_t>(contact.index2)].radius;
    overlaps += contact.overlap;
    lost += tolerance.of_geometry(std::min(one, two), one + two, not_given, by_row);
  }
  if (overlaps < lost / 3)
    rules.notes->add(
        "overlaps are not in the rows, and smaller than the digits of the coordinates: strain and stiffness "
        "are unknown (dump the overlap, or more digits)",
        rules.step);
}

}  // namespace mikromakro
