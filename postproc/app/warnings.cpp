// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/warnings.h"

#include <fmt/format.h>

#include <cstdio>
#include <set>

namespace mikromakro {

// Commands that read their input more than once find the same each time.
void tell(const std::string& warning) {
  static std::set<std::string> told;
  if (!told.insert(warning).second) return;
  fmt::print(stderr, "mikromakro: warning: {}\n", warning);
}

void tell(const Notes& notes) {
  for (const std::string& line : notes.lines()) tell(line);
}

void describe_notes(const Notes& notes, Preamble& lines) {
  for (std::string& line : notes.lines()) lines.emplace_back("warning", std::move(line));
}

}  // namespace mikromakro
