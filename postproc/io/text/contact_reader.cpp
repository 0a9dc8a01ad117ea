// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/contact_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/row_parser.h"
#include "io/text/contact_presets.h"
#include "joining/needed_columns.h"

namespace mikromakro {
namespace {

using enum ContactColumn;

// Relative to the in-plane components, for six digits; in a two-dimensional run nothing is out of plane.
constexpr double plane_tolerance = 1e-5;
constexpr ColumnSet normal_columns = column_set(nx, ny);
constexpr ColumnSet place_columns = column_set(x1, y1, x2, y2);
constexpr ColumnSet across_columns = column_set(z1, z2, fz, shearz, ftz);
constexpr ColumnSet tangential_columns = column_set(ftx, fty);
constexpr ColumnSet wall_name_columns = column_set(mesh);
constexpr ColumnSet kept_columns = column_bit(ContactColumn::count) - 1;

using Slots = std::array<double, static_cast<std::size_t>(read_count)>;

double& at(Slots& slots, ContactColumn column) {
  return slots[static_cast<std::size_t>(column)];
}

bool contains(ColumnSet set, ColumnSet columns) {
  return (columns & ~set) == 0;
}

// LIGGGHTS does not name the columns of a compute: c_X[1] c_X[2] ...
bool is_our_compute(const std::vector<std::string>& columns) {
  if (columns.size() != contact_disc_columns) return false;
  const std::string stem = columns[0].substr(0, columns[0].find('['));
  if (!stem.starts_with("c_")) return false;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] != fmt::format("{}[{}]", stem, i + 1)) return false;
  return true;
}

ColumnMap map_contacts(const DumpHeader& header, const ContactFormat& format, const Place& place) {
  const ColumnNames& names = format.walls ? wall_contact_names() : contact_names();
  const bool unnamed = format.list.empty() &&
                       std::find(header.columns.begin(), header.columns.end(), "id1") == header.columns.end();
  static const std::vector<std::string> preset = {"liggghts"};
  const auto list =
      expand_preset(unnamed && format.walls ? preset : format.list, header, format.walls, place);
  if (!list.empty()) return map_option(list, header.columns.size(), names, place);
  if (format.walls || !is_our_compute(header.columns)) {
    ColumnMap named = map_header(header.columns, names, place);
    if (named.given == 0 && header.columns.front().starts_with("c_"))
      throw bad_input(place, "columns without names (give them by --contact-columns)",
                      fmt::format("the {} of compute contact/disc in their order", contact_disc_columns),
                      fmt::format("{} from {} to {}", header.columns.size(), header.columns.front(),
                                  header.columns.back()));
    return named;
  }
  ColumnMap map;
  for (int slot = 0; slot < contact_disc_columns; ++slot) map.slot_of_column.push_back(slot);
  map.given = (ColumnSet{1} << static_cast<unsigned>(contact_disc_columns)) - 1;
  return map;
}

// Columns that are meaningless without others.
struct Group {
  ColumnSet any, all;
};
constexpr Group groups[] = {{normal_columns, normal_columns},
                            {place_columns, place_columns},
                            {column_set(z1, z2), column_set(z1, z2) | place_columns},
                            {column_set(fz), column_set(fx, fy)},
                            {column_set(shearx, sheary, shearz), column_set(shearx, sheary)},
                            {column_set(ftx, fty, ftz), column_set(ftx, fty, fx, fy)}};

void check_columns(const ColumnMap& map, const ColumnNames& names, const Place& place) {
  for (const Group& group : groups)
    if ((map.given & group.any) != 0) require_columns(map, group.all, names, place);
  if (contains(map.given, column_set(xi, shearx)))
    throw bad_input(place, "the spring is given twice", "xi, or shearx and sheary", "both");
}

void check_across(double across, double x, double y, std::string_view name, const Place& place) {
  if (std::abs(across) <= plane_tolerance * (std::abs(x) + std::abs(y))) return;
  throw bad_input(place, "the contact is not in the plane (columns of other quantities?)",
                  fmt::format("{} 0", name), fmt::format("{}", across));
}

void check_plane(Slots& row, ColumnSet given, const Place& place) {
  if (contains(given, column_set(fz))) check_across(at(row, fz), at(row, fx), at(row, fy), "fz", place);
  if (contains(given, column_set(ftz))) check_across(at(row, ftz), at(row, ftx), at(row, fty), "ftz", place);
  if (contains(given, column_set(shearz)))
    check_across(at(row, shearz), at(row, shearx), at(row, sheary), "shearz", place);
  if (contains(given, column_set(z1, z2) | place_columns))
    check_across(at(row, z2) - at(row, z1), at(row, x2) - at(row, x1), at(row, y2) - at(row, y1), "z2 - z1",
                 place);
}

/// fx fy and ftx fty are then the normal and the tangential force.
void check_tangential(Slots& row, const Place& place) {
  constexpr double rounding = 1e-6, turned = 0.05;
  const double normal = std::hypot(at(row, fx), at(row, fy)),
               tangential = std::hypot(at(row, ftx), at(row, fty));
  const double along = at(row, fx) * at(row, ftx) + at(row, fy) * at(row, fty);
  if (tangential <= rounding * normal || !(std::abs(along) > turned * normal * tangential)) return;
  throw bad_input(place,
                  "ftx fty is not perpendicular to the normal force fx fy (columns of other quantities?)",
                  fmt::format("a multiple of {:.6g} {:.6g}", -at(row, fy) / normal, at(row, fx) / normal),
                  fmt::format("{:.6g} {:.6g}", at(row, ftx), at(row, fty)));
}

/// Reads row by row into slots that each row overwrites.
class RowReader {
 public:
  RowReader(const DumpHeader& header, const ContactFormat& format, ColumnSet needed, const Place& place)
      : walls_(format.walls), map_(map_contacts(header, format, place)) {
    // The wall id may be missing, or is that of its mesh.
    if (walls_) map_.given |= column_set(id2);
    const ColumnNames& names = walls_ ? wall_contact_names() : contact_names();
    if (!walls_ && (map_.given & wall_name_columns) != 0)
      throw bad_input({names.option}, "meshes are walls", "their dump as --wall-contacts", "mesh");
    check_columns(map_, names, place);
    require_columns(map_, required_contact_columns(needed, map_.given), names, place);
    wall_map_ = map_;
    // In text fn and ft cost little, and reveal a modified force.
    const ColumnSet wanted =
        wanted_contact_columns(needed, map_.given, format.closely) | (map_.given & column_set(fn, ft));
    keep_columns(map_, wanted);
    keep_columns(wall_map_, wanted | place_columns);
    if (walls_) map_ = wall_map_;
    row_.fill(std::nan(""));
  }

  ColumnSet given() const { return map_.given & kept_columns; }

  void read(std::string_view line, ContactRow& row, const Place& place) {
    parse_row(line, map_, row_, place);
    // Wall rows are few, and their positions locate the wall.
    if (at(row_, id2) <= 0 && map_.given != wall_map_.given) parse_row(line, wall_map_, row_, place);
    if ((map_.given & across_columns) != 0) check_plane(row_, map_.given, place);
    if (contains(map_.given, tangential_columns)) {
      check_tangential(row_, place);
      at(row_, fx) += at(row_, ftx);
      at(row_, fy) += at(row_, fty);
    }
    if (walls_) name_wall(place);
    std::copy_n(row_.begin(), row.value.size(), row.value.begin());
  }

 private:
  void name_wall(const Place& place) {
    if (contains(map_.given, column_set(mesh)))
      at(row_, id2) = first_mesh - at(row_, mesh);
    else if (std::isnan(at(row_, id2)))
      at(row_, id2) = first_mesh;
    if (at(row_, id2) > 0)
      throw bad_input(place, "the contact is not with a wall", "id2 of a wall, 0 or less, or the column mesh",
                      fmt::format("{}", at(row_, id2)));
  }

  bool walls_;
  ColumnMap map_, wall_map_;
  Slots row_;
};

}  // namespace

ContactRows read_contacts(const RowBlock& block, const ContactFormat& format, ColumnSet needed) {
  const DumpHeader& header = block.header;
  Place place{block.file, header.line};
  if (header.of_particles())
    throw bad_input(place, "not a dump of contacts", "'ITEM: ENTRIES'", in_quotes("ITEM: " + header.label));
  RowReader reader(header, format, needed, place);

  ContactRows contacts;
  contacts.given = reader.given();
  contacts.needed = needed;
  contacts.file = block.file;
  contacts.first_line = header.line + 1;
  contacts.rows.reserve(static_cast<std::size_t>(header.rows));
  const bool guessed = format.list.empty() && is_our_compute(header.columns);
  ContactRow row;
  for (std::string_view rest = block.text; !rest.empty();) {
    ++place.line;
    reader.read(next_line(rest), row, place);
    contacts.rows.push_back(row);
    check_contact_row(row, contacts.given, guessed, place);
  }
  return contacts;
}

}  // namespace mikromakro
