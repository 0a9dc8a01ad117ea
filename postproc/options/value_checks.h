// SPDX-License-Identifier: GPL-2.0-or-later
// What values of options must be. Each check says of a value that fails 'what; expected ..., got ...', which
// stands behind the name of the option.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mikromakro {

CLI::Validator positive();
CLI::Validator not_negative();
CLI::Validator whole_number(std::int64_t low, std::int64_t high);
CLI::Validator one_of(std::vector<std::string_view> names);

/// Every option of `app` that takes numbers takes finite ones only, and whole ones where it counts: nan would
/// pass all comparisons, and 010 would be read as 8. No option takes an empty value, which would be as if it
/// had not been given. To be called when all options are there.
void check_values(CLI::App& app);

/// Throws at a list with commas that has an empty item (`0.03,,0.05`), which the parser would leave out.
/// `words` in their order, names of options with their dashes.
void check_lists(const CLI::App& app, const std::vector<std::string>& words);

/// What is wrong with the words that `app` was given, in the same form, with the option's name in front;
/// `listed` says where its options stand.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::string_view listed);

}  // namespace mikromakro
