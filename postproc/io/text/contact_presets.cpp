// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/contact_presets.h"

#include <fmt/format.h>

#include "model/error.h"

namespace mikromakro {
namespace {

using Names = std::vector<std::string>;

constexpr std::string_view liggghts = "liggghts";
constexpr std::string_view lammps = "lammps";

// Parts of the rows of the LIGGGHTS computes, in their order.
const Names places = {"x1", "y1", "z1", "x2", "y2", "z2"};
// For walls the contact point comes first.
const Names wall_places = {"x2", "y2", "z2", "x1", "y1", "z1"};
const Names velocities(6, "-");
const Names ids = {"id1", "id2", "periodic"};
const Names wall_ids = {"mesh", "-", "id1"};
const Names force = {"fx", "fy", "fz"};
const Names torque(3, "-");
const Names history = {"shearx", "sheary", "shearz"};
const Names area(1, "-");
const Names delta = {"overlap"};

Names joined(std::initializer_list<const Names*> parts) {
  Names all;
  for (const Names* part : parts) all.insert(all.end(), part->begin(), part->end());
  return all;
}

Names columns_of_liggghts(std::size_t count, bool walls, const Place& place) {
  const Names& x = walls ? wall_places : places;
  const Names& id = walls ? wall_ids : ids;
  const Names every[] = {joined({&id, &force}),
                         joined({&x, &id, &force}),
                         joined({&x, &id, &force, &delta}),
                         joined({&x, &id, &force, &history}),
                         joined({&x, &id, &force, &history, &delta}),
                         joined({&x, &velocities, &id, &force, &torque, &area}),
                         joined({&x, &velocities, &id, &force, &torque, &history, &area})};
  for (const Names& names : every)
    if (names.size() == count) return names;
  throw bad_input(place,
                  fmt::format("no {} of LIGGGHTS that is known here (name the columns one by one)",
                              walls ? "compute wall/gran/local" : "compute pair/gran/local"),
                  "6, 12, 13, 15, 16, 22 or 25 columns", fmt::format("{}", count));
}

// LAMMPS prepends a row index on request.
std::size_t counted_rows(const DumpHeader& header) {
  return header.columns.front() == "index" ? 1 : 0;
}

constexpr std::size_t short_row = 5, long_row = 7, most_extra = 10, tangential = 3;

Names columns_of_lammps(const DumpHeader& header, const Place& place) {
  Names names(counted_rows(header), "-");
  const std::size_t count = header.columns.size() - names.size();
  if (count != short_row && (count < long_row || count > long_row + most_extra))
    throw bad_input(place, "no compute pair/local of LAMMPS that is known here (name the columns one by one)",
                    "patom1 patom2 and dist fx fy, or dist force fx fy fz p1 ..., 5 or 7 to 17 columns",
                    fmt::format("{}", count));
  if (count == short_row)
    names.insert(names.end(), {"id1", "id2", "dist", "fx", "fy"});
  else
    names.insert(names.end(), {"id1", "id2", "dist", "-", "fx", "fy", "fz"});
  if (count >= long_row + tangential) names.insert(names.end(), {"ftx", "fty", "ftz"});
  names.resize(header.columns.size(), "-");
  return names;
}

bool is_preset(const Names& list, std::string_view name) {
  return list.size() == 1 && list.front() == name;
}

}  // namespace

Names expand_preset(const Names& list, const DumpHeader& header, bool walls, const Place& place) {
  if (is_preset(list, liggghts)) return columns_of_liggghts(header.columns.size(), walls, place);
  if (is_preset(list, lammps) && !walls) return columns_of_lammps(header, place);
  return list;
}

bool is_without_tangential_forces(const Names& list, const DumpHeader& header) {
  return is_preset(list, lammps) && header.columns.size() - counted_rows(header) < long_row + tangential;
}

}  // namespace mikromakro
