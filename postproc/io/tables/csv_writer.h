// SPDX-License-Identifier: GPL-2.0-or-later
// Writes tables as comma-separated text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/table.h"

namespace mikromakro {

/// Header of a table: pairs of name and value, one '#' line each.
using Preamble = std::vector<std::pair<std::string, std::string>>;

/// A number with 17 significant digits, which restores the same double; "nan" for every nan.
std::string number_text(double value);

/// '#' lines (the preamble, then unit, equation and meaning of each column), a line of names, one line per
/// row.
std::string csv_text(const Preamble& preamble, const Table& table);

}  // namespace mikromakro
