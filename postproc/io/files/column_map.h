// SPDX-License-Identifier: GPL-2.0-or-later
// Maps the columns of a dump to quantities.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/columns.h"
#include "model/error.h"
#include "model/notes.h"

namespace mikromakro {

/// For each column of the file, the slot (index of the quantity) that it fills; -1 for unused columns.
struct ColumnMap {
  /// A repeated column, which must hold the number already in the slot.
  struct Repeat {
    std::size_t column;
    int slot;
  };

  std::vector<int> slot_of_column;
  ColumnSet given = 0;
  std::vector<Repeat> repeats = {};
};

/// Column names of a kind of dump.
struct ColumnNames {
  std::span<const std::string_view> known;         ///< by slot
  std::span<const std::string_view> ignored;       ///< accepted in a user's list, but unused
  std::string_view option;                         ///< the option that names the columns if the file does not
  std::span<const std::string_view> presets = {};  ///< names of whole lists
};
const ColumnNames& particle_names();
const ColumnNames& contact_names();
const ColumnNames& wall_contact_names();

/// Map from the names in the file's header; unknown names are skipped, repeated ones (LIGGGHTS writes
/// whatever it is asked for) become repeats. Throws if there are no names.
ColumnMap map_header(const std::vector<std::string>& header, const ColumnNames& names, const Place& place);

/// Notes columns that the user's list and the file call by two known names that differ.
void note_other_names(const std::vector<std::string>& list, const std::vector<std::string>& header,
                      const ColumnNames& names, Notes* notes);

/// Map from the user's list, with '-' for columns to skip. Throws if the length of the list differs from that
/// of the header (unless the header names no columns: rows are then counted), and on unknown or repeated
/// names.
ColumnMap map_option(const std::vector<std::string>& list, std::size_t columns, const ColumnNames& names,
                     const Place& place);

/// Skips all columns except these.
void keep_columns(ColumnMap& map, ColumnSet columns);

/// Throws, naming the missing columns, unless all `needed` columns are given.
void require_columns(const ColumnMap& map, ColumnSet needed, const ColumnNames& names, const Place& place);

}  // namespace mikromakro
