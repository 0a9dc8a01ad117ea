// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/error.h"

#include <fmt/format.h>

namespace mikromakro {
namespace {

// Limits for file names, and for the other parts of a message, which may list all known names.
constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_part = 900;

// Multi-byte characters stay whole.
bool begins_letter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::string cut(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  std::size_t head = longest / 2, tail = text.size() - (longest - head - 3);
  while (head > 0 && !begins_letter(text[head])) --head;
  while (tail < text.size() && !begins_letter(text[tail])) ++tail;
  return fmt::format("{}...{}", text.substr(0, head), text.substr(tail));
}

}  // namespace

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line;
  for (const char c : cut(text, longest)) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) {
      line += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      line += c;
    }
  }
  return line;
}

Error bad_input(const Place& place, std::string_view what, std::string_view expected, std::string_view got) {
  const std::string file = one_line(place.file, longest_name);
  const std::string where = place.line > 0 ? fmt::format("{}:{}", file, place.line) : file;
  return {Error::Kind::bad_input,
          fmt::format("{}: {}; expected {}, got {}", where, one_line(what, longest_part),
                      one_line(expected, longest_part), one_line(got, longest_part))};
}

Error run_failed(std::string_view what, std::string_view expected, std::string_view got) {
  return {Error::Kind::run_failed,
          fmt::format("{}; expected {}, got {}", one_line(what, longest_part),
                      one_line(expected, longest_part), one_line(got, longest_part))};
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return fmt::format("'{}{}'", shown, text.size() > longest ? "..." : "");
}

}  // namespace mikromakro
