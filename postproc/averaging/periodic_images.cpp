// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/periodic_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double most_images = 10000;
// Tolerance for the ratio of two lengths meant to be equal, such as 0.3 - 0.1 and 0.2.
constexpr double rounding = 1e-12;

// The image with low <= x < low + period; an x already in that range is returned unchanged.
double wrapped(double x, double low, double period) {
  const double there = x - period * std::floor((x - low) / period);
  return there >= low && there - low < period ? there : low;
}

}  // namespace

PeriodicImages::PeriodicImages(const Box& box, const Box& part)
    : x_(axis_of(box, part, 0)), y_(axis_of(box, part, 1)), any_(x_.period > 0 || y_.period > 0) {}

PeriodicImages::Axis PeriodicImages::axis_of(const Box& box, const Box& part, Eigen::Index axis) {
  const double length = box.length()[axis];
  const double low = part.low[axis];
  const double high = part.high[axis];
  if (!box.periodic[static_cast<std::size_t>(axis)] || !(length > 0)) return {low, high, 0, 0};
  const double periods = (high - low) / length;
  const double whole = std::round(periods);
  return {low, high, length, std::abs(periods - whole) < rounding * whole ? whole : 0};
}

PeriodicImages::Row PeriodicImages::Axis::row(double x, double reach) const {
  if (period == 0) return {x, 0, 1};
  // Beyond this, rounding would displace the image by more than a millionth of the box.
  constexpr double farthest = 1e9;
  if (!(std::abs(x - low) < farthest * period))
    throw bad_input({"periodic box"}, "a disc is too far away to have an image in it",
                    fmt::format("positions within {} lengths of the box, {}", farthest, period),
                    fmt::format("{}", x));
  if (reach > 0)
    return {x, std::ceil((low - reach - x) / period), std::floor((high + reach - x) / period) + 1};
  const double first = wrapped(x, low, period);
  return {first, 0, whole > 0 ? whole : std::ceil((high - first) / period)};
}

double PeriodicImages::Axis::coordinate(const Row& row, double k, double reach) const {
  const double x = row.first + k * period;
  // Rounding must not place an image on the upper edge.
  return reach == 0 && whole > 0 && x >= high ? std::nextafter(high, low) : x;
}

void PeriodicImages::add(const Eigen::Vector2d& place, double reach,
                         std::vector<Eigen::Vector2d>& images) const {
  const Row columns = x_.row(place.x(), reach);
  const Row rows = y_.row(place.y(), reach);
  const double count = std::max(0.0, columns.end - columns.begin) * std::max(0.0, rows.end - rows.begin);
  if (!(count <= most_images))
    throw bad_input({"periodic box"}, "too many images of a disc for such volumes, or such a wide kernel",
                    fmt::format("at most {}", most_images), fmt::format("{}", count));
  for (double j = rows.begin; j < rows.end; ++j)
    for (double i = columns.begin; i < columns.end; ++i)
      images.emplace_back(x_.coordinate(columns, i, reach), y_.coordinate(rows, j, reach));
}

}  // namespace mikromakro
