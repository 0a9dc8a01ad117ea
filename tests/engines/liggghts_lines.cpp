// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine_lines.h"

namespace mikromakro::test {

std::vector<std::string> EngineLines::of(const std::string& line) {
  return {line};
}

}  // namespace mikromakro::test
