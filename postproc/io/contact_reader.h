// Contact rows of one dump frame, as they stand in the file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/dump_reader.h"
#include "io/further_piece.h"

namespace mikromakro {

/// One row, by ContactColumn; nan where the file has no such column.
struct ContactRow {
  std::array<double, static_cast<std::size_t>(ContactColumn::count)> value;

  double operator[](ContactColumn column) const { return value[static_cast<std::size_t>(column)]; }
};

/// The rows of a frame; row i stands in line first_line + i, or in lines[i] where some lines are no rows.
struct ContactRows {
  std::vector<ContactRow> rows;
  ColumnSet given = 0;
  ColumnSet needed = 0;
  std::string file;
  std::int64_t first_line = 0;
  std::vector<std::int64_t> lines = {};
  std::vector<FurtherPiece> pieces = {};  ///< without lines

  bool has(ColumnSet columns) const { return (columns & ~given) == 0; }
  /// The rows of a further piece of the frame.
  void append(const ContactRows& piece) {
    pieces.push_back({rows.size(), piece.file, piece.first_line});
    rows.insert(rows.end(), piece.rows.begin(), piece.rows.end());
    given &= piece.given;
  }

  Place place(std::size_t row) const {
    const std::int64_t line = lines.empty() ? first_line + static_cast<std::int64_t>(row) : lines[row];
    return place_of_row(row, {file, line}, pieces);
  }
};

/// Throws where an id is no whole number, or a normal is given that is no unit vector within 1e-5 (the
/// engines' %g keeps 6 digits). `guessed`: the columns have no names and only look like ours, which the
/// message then says.
void check_contact_row(const ContactRow& row, ColumnSet given, bool guessed, const Place& place);

/// The columns without which contacts cannot be joined: normal and overlap can be derived.
ColumnSet required_contact_columns(ColumnSet needed);

/// The columns that are read of those `given`: nothing that can be left out; all of them without any wish (to
/// copy frames).
ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given);

/// Reads the rows of a frame. `list` are the names of --contact-columns (empty: the header's own, or the
/// 16 columns of `compute contact/disc` where the header says c_X[1] ... c_X[16]); `needed` must be among
/// them, except for normal and overlap, which can be derived. Columns that are not wanted are skipped,
/// whatever they hold. Throws: missing columns, and all that check_contact_row throws.
ContactRows read_contacts(const RowBlock& block, const std::vector<std::string>& list, ColumnSet needed);

}  // namespace mikromakro
