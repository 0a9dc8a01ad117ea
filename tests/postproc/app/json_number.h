// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of the JSON that the program prints.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace mikromakro {

/// A number of a JSON object by its key; nan where there is none.
inline double json_number(const std::string& json, const std::string& key) {
  const auto at = json.find(std::string("\"").append(key).append("\":"));
  return at == std::string::npos ? std::nan("") : std::strtod(json.c_str() + at + key.size() + 3, nullptr);
}

}  // namespace mikromakro
