// SPDX-License-Identifier: GPL-2.0-or-later
// What a mistyped name was meant to be.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mikromakro {

/// How many letters must be put in, left out, exchanged, or swapped with their neighbours to make one word of
/// the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that is nearest to `given`; empty where more than a third of its letters, and more than one,
/// would have to change, and none begins with it.
std::string_view nearest_name(std::string_view given, std::span<const std::string_view> known);

/// For the end of an error: 'strss' (did you mean 'stress'?), without the question where nothing is near.
std::string in_quotes_with_guess(std::string_view given, std::span<const std::string_view> known);

}  // namespace mikromakro
