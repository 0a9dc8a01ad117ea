// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of one line of text into the slots of a column map.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "io/files/column_map.h"
#include "model/error.h"
#include "model/whole_number.h"

namespace mikromakro {

/// The next word of `rest` (blanks and tabs separate), cut off from it; empty at the end of the line.
std::string_view next_word(std::string_view& rest);

/// All words of a line.
std::vector<std::string_view> words(std::string_view line);

/// The next line of `rest` without its end (LF or CRLF), cut off from it; only to be called where there is
/// one.
std::string_view next_line(std::string_view& rest);

/// A finite number, as C prints decimal ones (`+5.0e-01`, too; not hexadecimal ones). Throws for anything
/// else, nan and inf and numbers beyond double included.
double parse_number(std::string_view word, const Place& place);

/// A whole number. Throws for anything else. Accepts whole numbers written as floating point (1e+06), as the
/// %g format of the engines' local dumps does.
std::int64_t parse_integer(std::string_view word, const Place& place);
/// Parses one row; slots that no column fills are left as they are. Throws on too few or too many columns, on
/// numbers that are none, and where a column that is there again holds another number.
void parse_row(std::string_view line, const ColumnMap& map, std::span<double> slots, const Place& place);

}  // namespace mikromakro
