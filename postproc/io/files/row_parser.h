// SPDX-License-Identifier: GPL-2.0-or-later
// Parses a line of text into the slots of a column map.
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

/// Removes the next word (separated by blanks and tabs) from `rest` and returns it; empty at the end of the
/// line.
std::string_view next_word(std::string_view& rest);

/// All words of a line.
std::vector<std::string_view> words(std::string_view line);

/// Removes the next line from `rest` and returns it without its end (LF or CRLF); requires that there is one.
std::string_view next_line(std::string_view& rest);

/// A finite decimal number as C prints it (also `+5.0e-01`; not hexadecimal). Throws on anything else,
/// including nan, inf and numbers out of the range of double.
double parse_number(std::string_view word, const Place& place);

/// An integer; also accepts integers written as floating-point numbers (1e+06), as in the %g format of the
/// engines' local dumps. Throws on anything else.
std::int64_t parse_integer(std::string_view word, const Place& place);
/// Parses one row; slots without a column are left unchanged. Throws on too few or too many columns, on
/// malformed numbers, and if a repeated column holds a different number.
void parse_row(std::string_view line, const ColumnMap& map, std::span<double> slots, const Place& place);

}  // namespace mikromakro
