// SPDX-License-Identifier: GPL-2.0-or-later
// Suggestions for misspelled names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mikromakro {

/// Number of insertions, deletions, substitutions and swaps of adjacent letters that turn one word into the
/// other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `given`; empty if more than a third of its letters (and more than one) would
/// have to change and no known name begins with it.
std::string_view nearest_name(std::string_view given, std::span<const std::string_view> known);

/// For the end of an error message: 'strss' (did you mean 'stress'?); without the question if no name is
/// near.
std::string in_quotes_with_guess(std::string_view given, std::span<const std::string_view> known);

}  // namespace mikromakro
