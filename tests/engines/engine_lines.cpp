// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine_lines.h"

#include <sstream>

namespace mikromakro::test {

std::string lines_of_engine(const std::string& script) {
  EngineLines lines;
  std::istringstream text(script);
  std::string all;
  for (std::string line; std::getline(text, line);)
    for (const auto& own : lines.of(line)) all += own + "\n";
  return all;
}

}  // namespace mikromakro::test
