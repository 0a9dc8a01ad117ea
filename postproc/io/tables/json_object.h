// SPDX-License-Identifier: GPL-2.0-or-later
// A minimal JSON object for the program's --json outputs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mikromakro {

/// Keys keep their insertion order; nan and inf become null, since JSON has no such numbers.
class JsonObject {
 public:
  void add(std::string_view key, double value);
  void add(std::string_view key, std::int64_t value);
  void add(std::string_view key, std::string_view value);
  void add(std::string_view key, const std::vector<std::string>& values);
  void add(std::string_view key, const std::vector<double>& values);
  void add(std::string_view key, const JsonObject& value);

  std::string text() const;

 private:
  void add_raw(std::string_view key, std::string value);

  std::vector<std::pair<std::string, std::string>> members_;
};

}  // namespace mikromakro
