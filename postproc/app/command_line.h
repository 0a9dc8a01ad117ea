// SPDX-License-Identifier: GPL-2.0-or-later
// Command-line arguments.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mikromakro {

/// The arguments in the order that the parser expects, last one first. Rewrites `-.2` as `-0.2`, since the
/// parser would take it for an option. Throws on lists with empty items.
std::vector<std::string> words_for_parser(const CLI::App& program, int argc, char** argv);

/// Describes a parse error: 'what; expected ..., got ...', with a pointer to the help of the intended verb.
std::string complaint_of(const CLI::App& program, const CLI::ParseError& error);

}  // namespace mikromakro
