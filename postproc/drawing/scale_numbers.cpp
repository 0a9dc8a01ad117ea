// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/scale_numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace mikromakro {

double round_below(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  // Rounding of the logarithm must not exclude a number that is itself round.
  constexpr double slack = 1 + 1e-12;
  for (const double leading : {10.0, 5.0, 2.0})
    if (leading * power <= x * slack) return leading * power;
  return power;
}

std::vector<double> ticks(double low, double high, int count) {
  const double wanted = (high - low) / count;
  double step = round_below(wanted);
  if (step < 0.75 * wanted) step = round_below(2.5 * step);
  const double slack = 1e-9 * (high - low);
  std::vector<double> all;
  for (auto i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
    all.push_back(i == 0 ? 0 : i * step);
  return all;
}

ScaledUnit scaled_unit(double size, const std::string& unit) {
  constexpr const char* prefixes[] = {"n", "\xC2\xB5", "m", "", "k", "M", "G"};
  constexpr int none = 3;
  if (unit.empty() || size == 0 || !std::isfinite(size)) return {1, unit};
  const auto thousands = static_cast<int>(std::floor(std::log10(std::abs(size)) / 3 + 1e-12));
  if (thousands < -none || thousands > none) return {1, unit};
  return {std::pow(1000.0, thousands), prefixes[thousands + none] + unit};
}

std::string label_text(double value) {
  return fmt::format("{:.6g}", value);
}

}  // namespace mikromakro
