// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/volume_outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace mikromakro {
namespace {

constexpr double longest_piece = 2;  // degrees

Eigen::Index place_of(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == table.columns.end() ? -1 : found - table.columns.begin();
}

// Part of a ring between two directions (degrees).
struct Sector {
  double inner, outer, begin, end;
};

void add_sector(const Sector& sector, const Eigen::Vector2d& center, Eigen::Index row,
                std::vector<Outline>& outlines) {
  const int pieces = static_cast<int>(std::ceil((sector.end - sector.begin) / longest_piece));
  const auto angle = [&](double piece) {
    return (sector.begin + (sector.end - sector.begin) * piece / pieces) * std::numbers::pi / 180;
  };
  const auto at = [&](double radius, int piece) -> Eigen::Vector2d {
    return center + radius * Eigen::Vector2d(std::cos(angle(piece)), std::sin(angle(piece)));
  };
  for (int i = 0; i < pieces; ++i)
    outlines.push_back(
        {{at(sector.inner, i), at(sector.outer, i), at(sector.outer, i + 1), at(sector.inner, i + 1)},
         row,
         angle(i + 0.5)});
}

}  // namespace

std::vector<Outline> volume_outlines(const Table& table, const Eigen::Vector2d& center) {
  const Eigen::Index inner = place_of(table, "r_inner");
  const Eigen::Index outer = place_of(table, "r_outer");
  const Eigen::Index begin = place_of(table, "phi_begin");
  const Eigen::Index x = place_of(table, "x_min");
  std::vector<Outline> outlines;
  for (Eigen::Index row = 0; row < table.rows.rows(); ++row) {
    if (inner >= 0 && outer >= 0) {
      const double first = begin < 0 ? 0 : table.rows(row, begin);
      const double last = begin < 0 ? 360 : table.rows(row, place_of(table, "phi_end"));
      add_sector({table.rows(row, inner), table.rows(row, outer), first, last}, center, row, outlines);
    }
    if (x < 0) continue;
    const double right = table.rows(row, place_of(table, "x_max"));
    const double low = table.rows(row, place_of(table, "y_min"));
    const double high = table.rows(row, place_of(table, "y_max"));
    const double left = table.rows(row, x);
    outlines.push_back({{{left, low}, {right, low}, {right, high}, {left, high}}, row});
  }
  return outlines;
}

}  // namespace mikromakro
