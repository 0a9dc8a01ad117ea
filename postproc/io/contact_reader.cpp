#include "io/contact_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/row_parser.h"

namespace mikromakro {
namespace {

constexpr double unit_tolerance = 1e-5;
constexpr ColumnSet normal_columns = column_set(ContactColumn::nx, ContactColumn::ny);
constexpr ColumnSet derivable_columns = normal_columns | column_set(ContactColumn::overlap);

// LIGGGHTS gives the columns of a compute no names: c_X[1] c_X[2] ...
bool is_our_compute(const std::vector<std::string>& columns) {
  if (columns.size() != contact_disc_columns) return false;
  const std::string stem = columns[0].substr(0, columns[0].find('['));
  if (!stem.starts_with("c_")) return false;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] != fmt::format("{}[{}]", stem, i + 1)) return false;
  return true;
}

ColumnMap map_contacts(const DumpHeader& header, const std::vector<std::string>& list, const Place& place) {
  if (!list.empty()) return map_option(list, header.columns.size(), contact_names(), place);
  if (!is_our_compute(header.columns)) return map_header(header.columns, contact_names(), place);
  ColumnMap map;
  for (int slot = 0; slot < contact_disc_columns; ++slot) map.slot_of_column.push_back(slot);
  map.given = (ColumnSet{1} << static_cast<unsigned>(contact_disc_columns)) - 1;
  return map;
}

// What was only guessed to be our columns needs the way out in its message.
std::string with_hint(std::string_view what, bool guessed) {
  return fmt::format("{}{}", what,
                     guessed ? " (not the columns of compute contact/disc? give --contact-columns)" : "");
}

}  // namespace

void check_contact_row(const ContactRow& row, ColumnSet given, bool guessed, const Place& place) {
  for (const ContactColumn column : {ContactColumn::id1, ContactColumn::id2}) {
    const double id = row[column];
    if (!is_integer(id))
      throw bad_input(place, with_hint("an id is no whole number", guessed), "a whole number",
                      fmt::format("{}", id));
  }
  if ((normal_columns & ~given) != 0) return;
  const double x = row[ContactColumn::nx];
  const double y = row[ContactColumn::ny];
  const double length = std::sqrt(x * x + y * y);
  if (!(std::abs(length - 1) <= unit_tolerance)) {
    throw bad_input(place, with_hint("the normal is no unit vector", guessed), "length 1 within 1e-5",
                    fmt::format("{}", length));
  }
}

ColumnSet required_contact_columns(ColumnSet needed) {
  return (needed & ~derivable_columns) | column_set(ContactColumn::id1, ContactColumn::id2);
}

ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given) {
  constexpr ColumnSet positions = column_set(ContactColumn::x1, ContactColumn::y1, ContactColumn::x2,
                                             ContactColumn::y2, ContactColumn::periodic);
  if (needed == 0) return given;
  const ColumnSet derive_from = (derivable_columns & ~given) != 0 ? positions : 0;
  // Fields take springs where there are any, without needing them.
  return given & (needed | derivable_columns | derive_from |
                  column_set(ContactColumn::id1, ContactColumn::id2, ContactColumn::xi));
}

ContactRows read_contacts(const RowBlock& block, const std::vector<std::string>& list, ColumnSet needed) {
  const DumpHeader& header = block.header;
  Place place{block.file, header.line};
  if (header.of_particles())
    throw bad_input(place, "not a dump of contacts", "'ITEM: ENTRIES'", in_quotes("ITEM: " + header.label));
  ColumnMap map = map_contacts(header, list, place);
  require_columns(map, required_contact_columns(needed), contact_names(), place);
  keep_columns(map, wanted_contact_columns(needed, map.given));

  ContactRows contacts;
  contacts.given = map.given;
  contacts.needed = needed;
  contacts.file = block.file;
  contacts.first_line = header.line + 1;
  contacts.rows.reserve(static_cast<std::size_t>(header.rows));
  const bool guessed = list.empty() && is_our_compute(header.columns);
  ContactRow row;
  row.value.fill(std::nan(""));
  for (std::string_view rest = block.text; !rest.empty();) {
    ++place.line;
    parse_row(next_line(rest), map, row.value, place);
    check_contact_row(row, map.given, guessed, place);
    contacts.rows.push_back(row);
  }
  return contacts;
}

}  // namespace mikromakro
