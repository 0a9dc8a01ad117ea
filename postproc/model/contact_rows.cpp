// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/contact_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace mikromakro {
namespace {

using enum ContactColumn;

// If the columns were only assumed to be ours, the message needs a remedy.
std::string with_hint(std::string_view what, bool guessed) {
  return fmt::format("{}{}", what,
                     guessed ? " (not the columns of compute contact/disc? give --contact-columns)" : "");
}

}  // namespace

void check_contact_row(const ContactRow& row, ColumnSet given, bool guessed, const Place& place) {
  if (is_sound(row, given)) return;
  for (const ContactColumn column : {id1, id2}) {
    const double id = row[column];
    if (!is_integer(id))
      throw bad_input(place, with_hint("an id is not a whole number", guessed), "a whole number",
                      fmt::format("{}", id));
  }
  throw bad_input(place, with_hint("the normal is not a unit vector", guessed),
                  "length 1 within 1e-5 (six digits)", fmt::format("{}", std::hypot(row[nx], row[ny])));
}

void add_wall_contacts(ContactRows walls, ContactRows& contacts) {
  contacts.pairs = contacts.rows.size();
  contacts.wall_file = std::move(walls.file);
  contacts.first_wall_line = walls.first_line;
  contacts.walls_given = walls.given;
  contacts.wall_pieces = std::move(walls.pieces);
  contacts.rows.insert(contacts.rows.end(), walls.rows.begin(), walls.rows.end());
}

}  // namespace mikromakro
