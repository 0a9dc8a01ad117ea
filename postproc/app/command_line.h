// SPDX-License-Identifier: GPL-2.0-or-later
// The words that the program is started with.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mikromakro {

/// As the parser takes them, last one first. `-.2` is a number, which it would take for an option. Throws at
/// lists with empty items.
std::vector<std::string> words_for_parser(const CLI::App& program, int argc, char** argv);

/// What is wrong with them: 'what; expected ..., got ...', with the help of the verb that was meant.
std::string complaint_of(const CLI::App& program, const CLI::ParseError& error);

}  // namespace mikromakro
