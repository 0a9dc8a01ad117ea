// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/column_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "model/nearest_name.h"

namespace mikromakro {
namespace {

// Columns of stock dumps without use in the plane, accepted so that a list can follow the stock names.
constexpr std::string_view ignored_particle_names[] = {"z", "vz", "omegax", "omegay", "fx", "fy", "fz"};

constexpr std::string_view presets[] = {"liggghts", "lammps"}, wall_presets[] = {"liggghts"};

int slot_of(std::string_view name, const ColumnNames& names) {
  const auto found = std::find(names.known.begin(), names.known.end(), name);
  return found == names.known.end() ? -1 : static_cast<int>(found - names.known.begin());
}

ColumnSet bit_of(int slot) {
  return slot < 0 ? 0 : ColumnSet{1} << static_cast<unsigned>(slot);
}

void append(ColumnMap& map, int slot) {
  map.given |= bit_of(slot);
  map.slot_of_column.push_back(slot);
}

std::string got_names(const std::vector<std::string>& list, const ColumnNames& names) {
  if (list.size() != 1) return fmt::format("{} names", list.size());
  const bool near = !nearest_name(list.front(), names.presets).empty();
  return near ? in_quotes_with_guess(list.front(), names.presets) : "1 name";
}

}  // namespace

const ColumnNames& particle_names() {
  static constexpr ColumnNames names{particle_column_names, ignored_particle_names, "--particle-columns"};
  return names;
}

const ColumnNames& contact_names() {
  static constexpr ColumnNames names{contact_read_names, {}, "--contact-columns", presets};
  return names;
}

const ColumnNames& wall_contact_names() {
  static constexpr ColumnNames names{contact_read_names, {}, "--wall-contact-columns", wall_presets};
  return names;
}

ColumnMap map_header(const std::vector<std::string>& header, const ColumnNames& names, const Place& place) {
  if (header.empty())
    throw bad_input(place, "no column names", fmt::format("names after the label, or {}", names.option),
                    "none");
  ColumnMap map;
  for (std::size_t column = 0; column < header.size(); ++column) {
    const int slot = slot_of(header[column], names);
    const bool again = (map.given & bit_of(slot)) != 0;
    if (again) map.repeats.push_back({column, slot});
    append(map, again ? -1 : slot);
  }
  return map;
}

void note_other_names(const std::vector<std::string>& list, const std::vector<std::string>& header,
                      const ColumnNames& names, Notes* notes) {
  if (notes == nullptr) return;
  for (std::size_t i = 0; i < std::min(list.size(), header.size()); ++i)
    if (list[i] != header[i] && list[i] != "-" && (slot_of(header[i], names) >= 0 || header[i] == "diameter"))
      notes->add(fmt::format("{}: column {} is {}, which the file calls {}", names.option, i + 1,
                             in_quotes(list[i]), in_quotes(header[i])));
}

ColumnMap map_option(const std::vector<std::string>& list, std::size_t columns, const ColumnNames& names,
                     const Place& place) {
  if (columns > 0 && list.size() != columns) {
    throw bad_input(place, fmt::format("{} does not fit the file", names.option),
                    fmt::format("{} names", columns), got_names(list, names));
  }
  ColumnMap map;
  for (const std::string& name : list) {
    const int slot = slot_of(name, names);
    const bool skipped =
        name == "-" || std::find(names.ignored.begin(), names.ignored.end(), name) != names.ignored.end();
    if (slot < 0 && !skipped) {
      throw bad_input({names.option}, "unknown column name",
                      fmt::format("one of {} or -", fmt::join(names.known, " ")),
                      in_quotes_with_guess(name, names.known));
    }
    if ((map.given & bit_of(slot)) != 0)
      throw bad_input({names.option}, "column named twice", "each name once", in_quotes(name));
    append(map, slot);
  }
  return map;
}

void keep_columns(ColumnMap& map, ColumnSet columns) {
  map.given &= columns;
  for (int& slot : map.slot_of_column)
    if ((bit_of(slot) & ~columns) != 0) slot = -1;
  std::erase_if(map.repeats, [&](const auto& repeat) { return (bit_of(repeat.slot) & columns) == 0; });
}

void require_columns(const ColumnMap& map, ColumnSet needed, const ColumnNames& names, const Place& place) {
  std::vector<std::string_view> missing;
  std::vector<std::string_view> given;
  for (std::size_t slot = 0; slot < names.known.size(); ++slot) {
    const ColumnSet bit = ColumnSet{1} << slot;
    if ((map.given & bit) != 0) given.push_back(names.known[slot]);
    if ((needed & bit & ~map.given) != 0) missing.push_back(names.known[slot]);
  }
  if (missing.empty()) return;
  const bool no_radius = std::find(missing.begin(), missing.end(), "radius") != missing.end();
  const std::string way_out =
      names.option.empty()
          ? ""
          : fmt::format(" ({}name them with {})",
                        no_radius ? "dump the engine's radius or diameter, or " : "", names.option);
  throw bad_input(place, "columns are missing" + way_out, fmt::format("{}", fmt::join(missing, " ")),
                  given.empty() ? "none that is recognized" : fmt::format("only {}", fmt::join(given, " ")));
}

}  // namespace mikromakro
