// SPDX-License-Identifier: GPL-2.0-or-later
// Floating-point numbers that represent ids, types and counts.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "model/error.h"

namespace mikromakro {

inline bool is_integer(double number) {
  constexpr double largest = 9007199254740992;  // 2^53: above it, distinct ids round to the same double
  return std::abs(number) <= largest && number == static_cast<double>(static_cast<std::int64_t>(number));
}
[[noreturn]] void throw_no_integer(double number, std::string_view what, const Place& place);
inline std::int64_t as_integer(double number, std::string_view what, const Place& place) {
  if (!is_integer(number)) throw_no_integer(number, what, place);
  return static_cast<std::int64_t>(number);
}

}  // namespace mikromakro
