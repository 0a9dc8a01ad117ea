// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/warnings.h"

#include <fmt/format.h>

#include <cstdio>
#include <set>

#include "verbs/listener.h"

namespace mikromakro {

// Commands that read their input more than once find the same each time.
void tell(const std::string& warning) {
  if (Listener* listener = Listener::of_this_thread()) return listener->warning(warning);
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
