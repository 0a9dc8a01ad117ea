// SPDX-License-Identifier: GPL-2.0-or-later
// JSON of the program's --json outputs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "model/table.h"

namespace mikromakro {

/// Keys keep their insertion order.
using Json = nlohmann::ordered_json;

/// The columns by their names, as lists.
Json json_of(const Table& table);

/// One line. nan and inf become null, since JSON has no such numbers; bytes that are not UTF-8 (in the name
/// of a file) are replaced.
std::string text_of(const Json& json);

}  // namespace mikromakro
