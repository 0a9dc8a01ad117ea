// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/json_object.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace mikromakro {
namespace {

std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

}  // namespace

void JsonObject::add_raw(std::string_view key, std::string value) {
  members_.emplace_back(json_string(key), std::move(value));
}

void JsonObject::add(std::string_view key, double value) {
  add_raw(key, json_number(value));
}
void JsonObject::add(std::string_view key, std::int64_t value) {
  add_raw(key, fmt::format("{}", value));
}
void JsonObject::add(std::string_view key, std::string_view value) {
  add_raw(key, json_string(value));
}
void JsonObject::add(std::string_view key, const JsonObject& value) {
  add_raw(key, value.text());
}

void JsonObject::add(std::string_view key, const std::vector<std::string>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const std::string& value : values) texts.push_back(json_string(value));
  add_raw(key, fmt::format("[{}]", fmt::join(texts, ", ")));
}

void JsonObject::add(std::string_view key, const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(json_number(value));
  add_raw(key, fmt::format("[{}]", fmt::join(texts, ", ")));
}

std::string JsonObject::text() const {
  std::vector<std::string> texts;
  texts.reserve(members_.size());
  for (const auto& [key, value] : members_) texts.push_back(fmt::format("{}: {}", key, value));
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

}  // namespace mikromakro
