// SPDX-License-Identifier: GPL-2.0-or-later
// Contact rows of one frame, as read from the file.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "model/columns.h"
#include "model/further_piece.h"
#include "model/whole_number.h"

namespace mikromakro {

/// One contact row, indexed by ContactColumn; nan if the file has no such column.
struct ContactRow {
  std::array<double, static_cast<std::size_t>(ContactColumn::count)> value;

  double operator[](ContactColumn column) const { return value[static_cast<std::size_t>(column)]; }
};

/// The contact rows of a frame. Row i is in line first_line + i, or in lines[i] if not every line is a row.
/// Wall contacts may come from a separate file: rows from `pairs` on, starting at line first_wall_line. Wall
/// rows keep their positions if the file gives them, even if those of disc rows are not needed.
struct ContactRows {
  std::vector<ContactRow> rows;
  ColumnSet given = 0;
  ColumnSet needed = 0;
  std::string file;
  std::int64_t first_line = 0;
  std::vector<std::int64_t> lines = {};
  std::vector<FurtherPiece> pieces = {};  ///< further pieces of the disc contacts; without `lines`
  std::string wall_file = {};
  std::int64_t first_wall_line = 0;
  std::vector<FurtherPiece> wall_pieces = {};  ///< counted from the first wall row
  std::size_t pairs = 0;
  ColumnSet walls_given = 0;

  bool of_wall_file(std::size_t row) const { return !wall_file.empty() && row >= pairs; }
  ColumnSet given_in(std::size_t row) const { return of_wall_file(row) ? walls_given : given; }
  /// Columns that all rows have.
  ColumnSet given_in_all() const { return wall_file.empty() ? given : given & walls_given; }
  /// Appends the rows of a further piece of the frame.
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

/// Mesh walls get ids below all others: mesh 0 has id2 = -1001, and so on.
inline constexpr double first_mesh = -1001;

/// Throws if an id is not an integer, or if a given normal is not a unit vector within 1e-5 (the engines' %g
/// keeps 6 digits). `guessed`: the columns are unnamed and were only assumed to be ours, which the message
/// then says.
void check_contact_row(const ContactRow& row, ColumnSet given, bool guessed, const Place& place);

/// True if check_contact_row() would not throw.
inline bool is_sound(const ContactRow& row, ColumnSet given) {
  if (!is_integer(row[ContactColumn::id1]) || !is_integer(row[ContactColumn::id2])) return false;
  if ((column_set(ContactColumn::nx, ContactColumn::ny) & ~given) != 0) return true;
  constexpr double unit_tolerance = 1e-5;
  const double x = row[ContactColumn::nx], y = row[ContactColumn::ny];
  return std::abs(x * x + y * y - 1) <= 2 * unit_tolerance;
}

/// Appends wall rows from a separate file to the disc rows.
void add_wall_contacts(ContactRows walls, ContactRows& contacts);

}  // namespace mikromakro
