// SPDX-License-Identifier: GPL-2.0-or-later
// Contact rows of one frame, as they stand in the file.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "model/columns.h"
#include "model/further_piece.h"
#include "model/whole_number.h"

namespace mikromakro {

/// One row, by ContactColumn; nan where the file has no such column.
struct ContactRow {
  std::array<double, static_cast<std::size_t>(ContactColumn::count)> value;

  double operator[](ContactColumn column) const { return value[static_cast<std::size_t>(column)]; }
};

/// The rows of a frame; row i stands in line first_line + i, or in lines[i] where some lines are no rows.
/// Those of walls may stand in a file of their own, behind row `pairs`, from line first_wall_line on. Rows of
/// walls have places where the file gives them, even if those of discs are not needed.
struct ContactRows {
  std::vector<ContactRow> rows;
  ColumnSet given = 0;
  ColumnSet needed = 0;
  std::string file;
  std::int64_t first_line = 0;
  std::vector<std::int64_t> lines = {};
  std::vector<FurtherPiece> pieces = {};  ///< of the discs; without lines
  std::string wall_file = {};
  std::int64_t first_wall_line = 0;
  std::vector<FurtherPiece> wall_pieces = {};  ///< counted from the first row of walls
  std::size_t pairs = 0;
  ColumnSet walls_given = 0;

  bool of_wall_file(std::size_t row) const { return !wall_file.empty() && row >= pairs; }
  ColumnSet given_in(std::size_t row) const { return of_wall_file(row) ? walls_given : given; }
  /// What all rows have.
  ColumnSet given_in_all() const { return wall_file.empty() ? given : given & walls_given; }
  /// Adds the rows of a further piece of the frame.
  void append(const ContactRows& piece) {
    pieces.push_back({rows.size(), piece.file, piece.first_line});
    rows.insert(rows.end(), piece.rows.begin(), piece.rows.end());
    given &= piece.given;
  }

  Place place(std::size_t row) const {
    if (of_wall_file(row)) {
      const std::size_t wall = row - pairs;
      return place_of_row(wall, {wall_file, first_wall_line + static_cast<std::int64_t>(wall)}, wall_pieces);
    }
    const std::int64_t line = lines.empty() ? first_line + static_cast<std::int64_t>(row) : lines[row];
    return place_of_row(row, {file, line}, pieces);
  }
};

/// Meshes of walls keep numbers of their own below all others: mesh 0 gets id2 = -1001, and so on.
inline constexpr double first_mesh = -1001;

/// Throws where an id is no whole number, or a normal is given that is no unit vector within 1e-5 (the
/// engines' %g keeps 6 digits). `guessed`: the columns have no names and only look like ours, which the
/// message then says.
void check_contact_row(const ContactRow& row, ColumnSet given, bool guessed, const Place& place);

/// Whether it would throw nothing.
inline bool is_sound(const ContactRow& row, ColumnSet given) {
  if (!is_integer(row[ContactColumn::id1]) || !is_integer(row[ContactColumn::id2])) return false;
  if ((column_set(ContactColumn::nx, ContactColumn::ny) & ~given) != 0) return true;
  constexpr double unit_tolerance = 1e-5;
  const double x = row[ContactColumn::nx], y = row[ContactColumn::ny];
  return std::abs(x * x + y * y - 1) <= 2 * unit_tolerance;
}

/// Adds the rows of walls, of a file of their own, to those of the discs.
void add_wall_contacts(ContactRows walls, ContactRows& contacts);

}  // namespace mikromakro
