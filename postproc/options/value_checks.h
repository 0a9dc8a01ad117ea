// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of option values. Each check returns 'what; expected ..., got ...' for an invalid value, to be
// printed after the option's name.
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

/// Restricts all numeric options of `app` to finite numbers, and to integers if they are counts: nan would
/// pass every comparison, and 010 would be read as 8. Also rejects empty values, which would look as if the
/// option had not been given. Call after all options have been added.
void check_values(CLI::App& app);

/// Throws on a comma-separated list with an empty item (`0.03,,0.05`), which the parser would drop. `words`
/// in order, option names with their dashes.
void check_lists(const CLI::App& app, const std::vector<std::string>& words);

/// Describes what is wrong with the words given to `app`, in the same form, preceded by the option's name;
/// `listed` says where its options are documented.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::string_view listed);

}  // namespace mikromakro
