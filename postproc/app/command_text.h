// SPDX-License-Identifier: GPL-2.0-or-later
// Command lines as text, from the options that were given.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>

namespace mikromakro {

/// A word as a shell takes it: in single quotes unless it is plain.
std::string shell_word(const std::string& word);

/// The given options of `app` whose names (`--rings`; `input` for positional arguments) are wanted, in the
/// order of the help, each with a space in front.
std::string given_options(const CLI::App& app, const std::function<bool(std::string_view)>& wanted);

}  // namespace mikromakro
