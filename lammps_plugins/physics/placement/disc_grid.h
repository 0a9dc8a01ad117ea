// SPDX-License-Identifier: GPL-2.0-or-later
// Cell grid over a rectangle for neighbour searches, used to place discs without overlaps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "physics/placement/disc_region.h"

namespace mikromakro::physics {

struct PlacedDisc {
  double x = 0.0, y = 0.0;  // m
  double radius = 0.0;      // m
};

class DiscGrid {
 public:
  // Cells are at least as wide as the largest disc, so touching discs are in the same or in adjacent cells.
  DiscGrid(const Rectangle& bounds, double largest_radius)
      : bounds_(bounds),
        width_(std::max({2.0 * largest_radius, (bounds.x_max - bounds.x_min) / most_cells_per_side,
                         (bounds.y_max - bounds.y_min) / most_cells_per_side})),
        columns_(static_cast<int>((bounds.x_max - bounds.x_min) / width_) + 1),
        rows_(static_cast<int>((bounds.y_max - bounds.y_min) / width_) + 1),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  // Discs outside the rectangle go to the nearest border cell; clamping keeps touching discs in adjacent
  // cells.
  void add(const PlacedDisc& disc) { cell(column_of(disc.x), row_of(disc.y)).push_back(disc); }

  [[nodiscard]] bool touches(const PlacedDisc& disc) const {
    const int i = column_of(disc.x);
    const int j = row_of(disc.y);
    for (int row = std::max(j - 1, 0); row <= std::min(j + 1, rows_ - 1); ++row) {
      for (int column = std::max(i - 1, 0); column <= std::min(i + 1, columns_ - 1); ++column) {
        const auto& discs = cells_[index(column, row)];
        if (std::ranges::any_of(discs, [&](const PlacedDisc& other) { return overlap(disc, other); }))
          return true;
      }
    }
    return false;
  }

 private:
  // Limits memory when the discs are tiny compared with the region.
  static constexpr int most_cells_per_side = 2000;

  static bool overlap(const PlacedDisc& a, const PlacedDisc& b) {
    const double dx = a.x - b.x;
    const double dy = a.y - b.y;
    const double contact_distance = a.radius + b.radius;
    return dx * dx + dy * dy < contact_distance * contact_distance;
  }
  // Clamped before conversion: a distant obstacle would overflow an int.
  [[nodiscard]] int column_of(double x) const {
    return static_cast<int>(std::clamp((x - bounds_.x_min) / width_, 0.0, columns_ - 1.0));
  }
  [[nodiscard]] int row_of(double y) const {
    return static_cast<int>(std::clamp((y - bounds_.y_min) / width_, 0.0, rows_ - 1.0));
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  std::vector<PlacedDisc>& cell(int column, int row) { return cells_[index(column, row)]; }

  Rectangle bounds_;
  double width_;
  int columns_;
  int rows_;
  std::vector<std::vector<PlacedDisc>> cells_;
};

}  // namespace mikromakro::physics
