// SPDX-License-Identifier: GPL-2.0-or-later
// Which column of a dump holds which quantity.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/columns.h"
#include "model/error.h"

namespace mikromakro {

/// For each column of the file the slot (index of the quantity) that it fills, -1 for a column that nobody
/// asks for.
struct ColumnMap {
  /// A column that stands in the file again: it must hold the number that is in the slot already.
  struct Repeat {
    std::size_t column;
    int slot;
  };

  std::vector<int> slot_of_column;
  ColumnSet given = 0;
  std::vector<Repeat> repeats = {};
};

/// What a kind of dump may contain.
struct ColumnNames {
  std::span<const std::string_view> known;    ///< by slot
  std::span<const std::string_view> ignored;  ///< names that a user's list may contain without any use
  std::string_view option;                    ///< the option that gives names where the file has none
};
const ColumnNames& particle_names();
const ColumnNames& contact_names();
const ColumnNames& wall_contact_names();

/// Map from the names in the file's header; names that we do not know are skipped. One that is there twice
/// (LIGGGHTS writes what it is told) is a repeat. Throws where there are no names.
ColumnMap map_header(const std::vector<std::string>& header, const ColumnNames& names, const Place& place);

/// Map from the user's list, '-' for a column to skip. Throws when the list has another length than the
/// header (unless that names no columns: rows will be counted) or a name that is unknown or there twice.
ColumnMap map_option(const std::vector<std::string>& list, std::size_t columns, const ColumnNames& names,
                     const Place& place);

/// Skips all columns but these.
void keep_columns(ColumnMap& map, ColumnSet columns);

/// Throws, naming the missing columns, unless all of `needed` are given.
void require_columns(const ColumnMap& map, ColumnSet needed, const ColumnNames& names, const Place& place);

}  // namespace mikromakro
