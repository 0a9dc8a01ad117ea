// SPDX-License-Identifier: GPL-2.0-or-later
// Variables of the command line that the script does not use: engines accept any name, so that a mistyped one
// leaves the script's default in place without a word.
#pragma once

#include <string>
#include <vector>

namespace mikromakro::styles {

/// A line for each variable given by -var (-v) whose name does not occur in the script given by -in (-i), nor
/// in the scripts that it includes or jumps to; with the most similar name that they define. Empty if there
/// is no such script, or if it includes a file that cannot be read here or whose name is itself made of
/// variables.
std::vector<std::string> unnamed_variables(const std::vector<std::string>& arguments);

}  // namespace mikromakro::styles
