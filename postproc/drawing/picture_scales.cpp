// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "drawing/picture.h"

namespace mikromakro {
namespace {

double percentile(std::vector<double>& values, double part) {
  const auto place = static_cast<std::size_t>(std::lround(part * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

Limits colour_limits(std::vector<double> values, DiscQuantity quantity) {
  constexpr double most = 0.99;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (quantity == DiscQuantity::velocity || quantity == DiscQuantity::pressure)
    return {std::min(0.0, percentile(values, 1 - most)), percentile(values, most)};
  if (quantity != DiscQuantity::spin) return {*low, *high};
  for (double& value : values) value = std::abs(value);
  const double end = percentile(values, most);
  return {-end, end};
}

// Extent of all discs; along a periodic axis that of the box, where discs are cut and continue at the other
// end.
Box window_of(const Frame& frame) {
  Limits x;
  Limits y;
  for (const Particle& particle : frame.particles) {
    for (const double side : {-particle.radius, particle.radius}) {
      x.add(particle.position.x() + side);
      y.add(particle.position.y() + side);
    }
  }
  Box window{{x.low, y.low}, {x.high, y.high}, {}};
  for (const Eigen::Index axis : {0, 1}) {
    if (!frame.box.periodic[static_cast<std::size_t>(axis)]) continue;
    window.low[axis] = frame.box.low[axis];
    window.high[axis] = frame.box.high[axis];
  }
  return window;
}

}  // namespace

void Limits::add(double number) {
  const bool first = empty();
  low = first ? number : std::min(low, number);
  high = first ? number : std::max(high, number);
}

void Limits::add(const Limits& other) {
  if (other.empty()) return;
  add(other.low);
  add(other.high);
}

void PictureScales::add(const Frame& frame, const PictureStyle& style) {
  const Box all = window_of(frame);
  if (!frame.particles.empty())
    window = window ? Box{window->low.cwiseMin(all.low), window->high.cwiseMax(all.high), {}} : all;
  for (const Contact& contact : frame.contacts) {
    const double size = std::abs(contact.force.dot(contact.normal));
    mean_force += (size - mean_force) / static_cast<double>(++contacts);
  }
  if (style.quantity == nullptr) return;
  const std::vector<double> values = disc_values(frame, style.quantity->quantity, style.height);
  std::vector<double> of_bulk;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_bulk(frame.particles[i], style)) of_bulk.push_back(values[i]);
  if (of_bulk.empty()) return;
  for (const double value : of_bulk) this->values.add(value);
  colours.add(colour_limits(std::move(of_bulk), style.quantity->quantity));
}

bool is_bulk(const Particle& particle, const PictureStyle& style) {
  const auto& types = style.bulk_types;
  return types.empty() || std::find(types.begin(), types.end(), particle.type) != types.end();
}

}  // namespace mikromakro
