// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "model/error.h"

namespace mikromakro {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Three rows of the matrix of distances between the first i letters of a and the first j of b.
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  std::iota(now.begin(), now.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(now);
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, exchanged});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
  }
  return now[b.size()];
}

std::string_view nearest_name(std::string_view given, std::span<const std::string_view> known) {
  constexpr std::size_t longest = 100;  // longer words are not misspelled names
  if (given.size() > longest) return {};
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string_view name : known) {
    const std::size_t distance = edit_distance(given, name);
    if (distance >= least || distance >= name.size()) continue;
    least = distance;
    nearest = name;
  }
  if (!nearest.empty() || given.size() < 3) return nearest;
  const auto longer = std::find_if(known.begin(), known.end(),
                                   [given](std::string_view name) { return name.starts_with(given); });
  return longer == known.end() ? std::string_view{} : *longer;
}

std::string in_quotes_with_guess(std::string_view given, std::span<const std::string_view> known) {
  const std::string_view meant = nearest_name(given, known);
  return meant.empty() ? in_quotes(given) : fmt::format("{} (did you mean '{}'?)", in_quotes(given), meant);
}

}  // namespace mikromakro
