// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/whole_number.h"

#include <fmt/format.h>

namespace mikromakro {

void throw_no_integer(double number, std::string_view what, const Place& place) {
  throw bad_input(place, fmt::format("{} is not a whole number", what), "a whole number",
                  fmt::format("{}", number));
}

}  // namespace mikromakro
