// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/grid_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "averaging/kernels/grid_kernel.h"
#include "averaging/volumes/disc_corner_area.h"
#include "averaging/volumes/reached_intervals.h"
#include "model/error.h"

namespace mikromakro {
namespace {

void check_edges(const std::vector<double>& edges) {
  if (edges.size() < 2)
    throw bad_input({"--grid"}, "too few edges", "2 or more", fmt::format("{}", edges.size()));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!std::isfinite(edges[i]) || (i > 0 && !(edges[i] > edges[i - 1])))
      throw bad_input({"--grid"}, "edges do not increase", "finite numbers, each larger than the one before",
                      fmt::format("{}", edges[i]));
  }
}

int interval_of(const std::vector<double>& edges, double x) {
  if (!(x >= edges.front()) || x >= edges.back()) return -1;
  return static_cast<int>(std::upper_bound(edges.begin(), edges.end(), x) - edges.begin()) - 1;
}

// Whether a disc lies entirely in one interval along one axis.
bool is_within(const std::vector<double>& edges, const Intervals& reached, double centre, double radius) {
  return reached.last == reached.first + 1 &&
         edges[static_cast<std::size_t>(reached.first)] <= centre - radius &&
         centre + radius <= edges[static_cast<std::size_t>(reached.last)];
}

}  // namespace

std::vector<double> equal_grid_edges(double low, double high, int count, std::string_view option) {
  if (!(low < high) || !std::isfinite(low) || !std::isfinite(high))
    throw bad_input({option}, "no rectangles between these edges", "MIN < MAX",
                    fmt::format("{} {}", low, high));
  if (count < 1) throw bad_input({option}, "no rectangles", "1 or more", fmt::format("{}", count));
  std::vector<double> edges;
  edges.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i < count; ++i) edges.push_back(low + (high - low) * i / count);
  edges.push_back(high);
  return edges;
}

GridVolumes::GridVolumes(std::vector<double> x_edges, std::vector<double> y_edges, double height)
    : x_edges_(std::move(x_edges)), y_edges_(std::move(y_edges)), height_(height) {
  check_edges(x_edges_);
  check_edges(y_edges_);
  if (!(height > 0) || !std::isfinite(height))
    throw bad_input({"--height"}, "the thickness is not positive", "a number > 0", fmt::format("{}", height));
}

Eigen::ArrayXd GridVolumes::measure() const {
  const Rows bounds = coordinates();
  return (bounds.col(1) - bounds.col(0)) * (bounds.col(3) - bounds.col(2)) * height_;
}

void GridVolumes::slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const {
  const Intervals x = reached_intervals(x_edges_, centre[0] - radius, centre[0] + radius);
  const Intervals y = reached_intervals(y_edges_, centre[1] - radius, centre[1] + radius);
  if (x.first >= x.last) return;
  // Fast path for most discs if rectangles are large.
  if (is_within(x_edges_, x, centre[0], radius) && is_within(y_edges_, y, centre[1], radius)) {
    shares.push_back({y.first * columns_of_cells() + x.first, 1.0});
    return;
  }
  // Fraction of the disc to the left of an x edge and below a y edge.
  const auto corner = [&](int i, int j) {
    return disc_quadrant_area((x_edges_[static_cast<std::size_t>(i)] - centre[0]) / radius,
                              (y_edges_[static_cast<std::size_t>(j)] - centre[1]) / radius) /
           std::numbers::pi;
  };
  for (int j = y.first; j < y.last; ++j) {
    double left = corner(x.first, j + 1) - corner(x.first, j);
    for (int i = x.first; i < x.last; ++i) {
      const double next = corner(i + 1, j + 1) - corner(i + 1, j);
      if (next - left > smallest_share) shares.push_back({j * columns_of_cells() + i, next - left});
      left = next;
    }
  }
}

int GridVolumes::find(const Eigen::Vector2d& point) const {
  const int i = interval_of(x_edges_, point[0]);
  const int j = interval_of(y_edges_, point[1]);
  return i < 0 || j < 0 ? -1 : j * columns_of_cells() + i;
}

std::unique_ptr<const PointShares> GridVolumes::point_shares(std::shared_ptr<const Kernel> kernel) const {
  return grid_kernel(std::move(kernel), x_edges_, y_edges_);
}

std::vector<Column> GridVolumes::columns() const {
  return {{"x_min", "m", "-", "left edge"},  {"x_max", "m", "-", "right edge"},
          {"y_min", "m", "-", "lower edge"}, {"y_max", "m", "-", "upper edge"},
          {"x", "m", "-", "mean of both"},   {"y", "m", "-", "mean of both"}};
}

Rows GridVolumes::coordinates() const {
  Rows rows(count(), 6);
  for (int cell = 0; cell < count(); ++cell) {
    const auto i = static_cast<std::size_t>(cell % columns_of_cells());
    const auto j = static_cast<std::size_t>(cell / columns_of_cells());
    const double left = x_edges_[i];
    const double right = x_edges_[i + 1];
    const double bottom = y_edges_[j];
    const double top = y_edges_[j + 1];
    rows.row(cell) << left, right, bottom, top, 0.5 * (left + right), 0.5 * (bottom + top);
  }
  return rows;
}

}  // namespace mikromakro
