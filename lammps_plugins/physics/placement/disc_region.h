// SPDX-License-Identifier: GPL-2.0-or-later
// Regions that can be filled with discs: an annulus or a rectangle.
#pragma once

#include <cmath>
#include <numbers>
#include <variant>

namespace mikromakro::physics {

struct Rectangle {
  double x_min = 0.0, x_max = 0.0, y_min = 0.0, y_max = 0.0;  // m

  [[nodiscard]] double area() const { return (x_max - x_min) * (y_max - y_min); }
  [[nodiscard]] Rectangle bounds() const { return *this; }
  // True if (x, y) is at least `margin` inside the border; the margin includes the disc's radius.
  [[nodiscard]] bool contains(double x, double y, double margin) const {
    return x - x_min >= margin && x_max - x >= margin && y - y_min >= margin && y_max - y >= margin;
  }
  [[nodiscard]] bool can_hold(double margin) const {
    return x_max - x_min >= 2.0 * margin && y_max - y_min >= 2.0 * margin;
  }
};

struct Annulus {
  double x = 0.0, y = 0.0;              // centre (m)
  double r_inner = 0.0, r_outer = 0.0;  // m

  [[nodiscard]] double area() const { return std::numbers::pi * (r_outer * r_outer - r_inner * r_inner); }
  [[nodiscard]] Rectangle bounds() const { return {x - r_outer, x + r_outer, y - r_outer, y + r_outer}; }
  [[nodiscard]] bool contains(double px, double py, double margin) const {
    const double distance = std::hypot(px - x, py - y);
    // r_inner = 0: a full circle, without an inner border.
    return (r_inner == 0.0 || distance - r_inner >= margin) && r_outer - distance >= margin;
  }
  [[nodiscard]] bool can_hold(double margin) const {
    return r_inner == 0.0 ? r_outer >= margin : r_outer - r_inner >= 2.0 * margin;
  }
};

using DiscRegion = std::variant<Annulus, Rectangle>;

inline double area_of(const DiscRegion& region) {
  return std::visit([](const auto& r) { return r.area(); }, region);
}
inline Rectangle bounds_of(const DiscRegion& region) {
  return std::visit([](const auto& r) { return r.bounds(); }, region);
}
inline bool contains_disc(const DiscRegion& region, double x, double y, double margin) {
  return std::visit([&](const auto& r) { return r.contains(x, y, margin); }, region);
}
inline bool can_hold_disc(const DiscRegion& region, double margin) {
  return std::visit([&](const auto& r) { return r.can_hold(margin); }, region);
}

}  // namespace mikromakro::physics
