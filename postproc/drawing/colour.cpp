// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/colour.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mikromakro {
namespace {

// Every 16th of the map's 256 entries.
constexpr double anchors[][3] = {{0.2670, 0.0049, 0.3294}, {0.2823, 0.0950, 0.4173}, {0.2788, 0.1755, 0.4834},
                                 {0.2590, 0.2515, 0.5247}, {0.2297, 0.3224, 0.5457}, {0.1994, 0.3876, 0.5546},
                                 {0.1727, 0.4488, 0.5579}, {0.1490, 0.5081, 0.5573}, {0.1276, 0.5669, 0.5506},
                                 {0.1206, 0.6258, 0.5335}, {0.1579, 0.6838, 0.5017}, {0.2461, 0.7389, 0.4520},
                                 {0.3692, 0.7889, 0.3829}, {0.5160, 0.8312, 0.2943}, {0.6785, 0.8637, 0.1895},
                                 {0.8456, 0.8873, 0.0997}, {0.9932, 0.9062, 0.1439}};

double linear_light(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

}  // namespace

Colour viridis(double x) {
  const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(std::size(anchors) - 1);
  const auto low = std::min(static_cast<std::size_t>(place), std::size(anchors) - 2);
  const double part = place - static_cast<double>(low);
  const auto mix = [&](int i) { return (1 - part) * anchors[low][i] + part * anchors[low + 1][i]; };
  return {mix(0), mix(1), mix(2), 1};
}

double lightness(const Colour& colour) {
  const double luminance = 0.2126 * linear_light(colour.red) + 0.7152 * linear_light(colour.green) +
                           0.0722 * linear_light(colour.blue);
  return luminance > 216.0 / 24389 ? 116 * std::cbrt(luminance) - 16 : luminance * 24389.0 / 27;
}

}  // namespace mikromakro
