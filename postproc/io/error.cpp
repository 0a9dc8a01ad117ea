#include "io/error.h"

#include <fmt/format.h>

namespace mikromakro {

Error bad_input(const Place& place, std::string_view what, std::string_view expected, std::string_view got) {
  const std::string where =
      place.line > 0 ? fmt::format("{}:{}", place.file, place.line) : std::string(place.file);
  return {Error::Kind::bad_input, fmt::format("{}: {}; expected {}, got {}", where, what, expected, got)};
}

Error run_failed(std::string_view what, std::string_view expected, std::string_view got) {
  return {Error::Kind::run_failed, fmt::format("{}; expected {}, got {}", what, expected, got)};
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return fmt::format("'{}{}'", shown, text.size() > longest ? "..." : "");
}

}  // namespace mikromakro
