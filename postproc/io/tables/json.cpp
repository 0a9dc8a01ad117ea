// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/json.h"

namespace mikromakro {

std::string text_of(const Json& json) {
  constexpr int one_line = -1;
  return json.dump(one_line, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mikromakro
