#include "averaging/volume_outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace mikromakro {
namespace {

constexpr int pieces_of_a_turn = 180;

Eigen::Index place_of(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == table.columns.end() ? -1 : found - table.columns.begin();
}

void add_ring(double inner, double outer, const Eigen::Vector2d& center, Eigen::Index row,
              std::vector<Outline>& outlines) {
  constexpr double step = 2 * std::numbers::pi / pieces_of_a_turn;
  const auto at = [&](double radius, int piece) -> Eigen::Vector2d {
    return center + radius * Eigen::Vector2d(std::cos(piece * step), std::sin(piece * step));
  };
  for (int i = 0; i < pieces_of_a_turn; ++i)
    outlines.push_back({{at(inner, i), at(outer, i), at(outer, i + 1), at(inner, i + 1)}, row});
}

}  // namespace

std::vector<Outline> volume_outlines(const Table& table, const Eigen::Vector2d& center) {
  const Eigen::Index inner = place_of(table, "r_inner");
  const Eigen::Index outer = place_of(table, "r_outer");
  const Eigen::Index x = place_of(table, "x_min");
  std::vector<Outline> outlines;
  for (Eigen::Index row = 0; row < table.rows.rows(); ++row) {
    if (inner >= 0 && outer >= 0)
      add_ring(table.rows(row, inner), table.rows(row, outer), center, row, outlines);
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
