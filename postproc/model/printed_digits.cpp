// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/printed_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace mikromakro {

void PrintedDigits::add(double number) {
  if (number == 0 || !std::isfinite(number)) return;
  ++count_;
  floats_ = floats_ && std::abs(number) <= std::numeric_limits<float>::max() &&
            static_cast<double>(static_cast<float>(number)) == number;
  // With this many digits, the file preserves the precision of the calculation.
  constexpr int all_that_matter = 15;
  if (digits_ >= all_that_matter) return;
  // The shortest text that represents this number: d.ddde+dd.
  std::array<char, 32> text{};
  const auto [end, code] =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(number), std::chars_format::scientific);
  const auto mantissa = static_cast<int>(std::find(text.data(), end, 'e') - text.data());
  digits_ = std::max(digits_, mantissa > 1 ? mantissa - 1 : 1);
}

double PrintedDigits::rounding(double size) const {
  if (size == 0) return 0;
  constexpr int of_a_float = 7;
  const int told = floats_ ? std::min(digits_, of_a_float) : digits_;
  const int digits = count_ < enough ? std::max(told, least) : told;
  return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(size))) + 1 - digits);
}

}  // namespace mikromakro
