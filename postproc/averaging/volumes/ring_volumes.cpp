// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/ring_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "averaging/kernels/ring_kernel.h"
#include "averaging/volumes/disc_circle_area.h"
#include "model/error.h"

namespace mikromakro {

std::vector<double> equal_ring_edges(double inner, double outer, int count) {
  if (!(inner >= 0) || !(outer > inner) || !std::isfinite(outer))
    throw bad_input({"--rings"}, "no rings between these radii", "0 <= RMIN < RMAX",
                    fmt::format("{} {}", inner, outer));
  if (count < 1) throw bad_input({"--rings"}, "no rings", "N of 1 or more", fmt::format("{}", count));
  std::vector<double> edges;
  edges.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i < count; ++i) edges.push_back(inner + (outer - inner) * i / count);
  edges.push_back(outer);
  return edges;
}

RingVolumes::RingVolumes(const Eigen::Vector2d& centre, std::vector<double> edges, double height)
    : centre_(centre), edges_(std::move(edges)), height_(height) {
  if (edges_.size() < 2)
    throw bad_input({"--edges"}, "too few edges", "2 or more radii", fmt::format("{}", edges_.size()));
  if (!(edges_[0] >= 0))
    throw bad_input({"--edges"}, "negative radius", "0 or more", fmt::format("{}", edges_[0]));
  for (std::size_t i = 1; i < edges_.size(); ++i) {
    if (!(edges_[i] > edges_[i - 1]) || !std::isfinite(edges_[i])) {
      throw bad_input({"--edges"}, "radii do not increase", fmt::format("more than {}", edges_[i - 1]),
                      fmt::format("{}", edges_[i]));
    }
  }
  if (!(height > 0) || !std::isfinite(height))
    throw bad_input({"--height"}, "the thickness is not positive", "a number > 0", fmt::format("{}", height));
}

Eigen::ArrayXd RingVolumes::measure() const {
  Eigen::ArrayXd measure(count());
  for (int i = 0; i < count(); ++i) {
    const double inner = edges_[static_cast<std::size_t>(i)];
    const double outer = edges_[static_cast<std::size_t>(i) + 1];
    measure[i] = std::numbers::pi * (outer - inner) * (outer + inner) * height_;
  }
  return measure;
}

Eigen::ArrayXd RingVolumes::radii() const {
  return coordinates().col(2);
}

Eigen::Matrix2d RingVolumes::basis(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d arm = point - centre_;
  const double distance = arm.norm();
  if (distance == 0) return Eigen::Matrix2d::Identity();
  const Eigen::Vector2d e_r = arm / distance;
  return (Eigen::Matrix2d() << e_r[0], e_r[1], -e_r[1], e_r[0]).finished();
}

void RingVolumes::slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const {
  const double distance = (centre - centre_).norm();
  const double disc_area = std::numbers::pi * radius * radius;
  // The first ring that extends beyond the disc's point nearest to the centre.
  const auto first = std::upper_bound(edges_.begin() + 1, edges_.end(), distance - radius);
  if (first == edges_.end()) return;
  double inside = disc_circle_area(distance, radius, *(first - 1));
  for (auto outer = first; outer != edges_.end() && inside < disc_area; ++outer) {
    const double next = disc_circle_area(distance, radius, *outer);
    if (next > inside)
      shares.push_back({static_cast<int>(outer - edges_.begin()) - 1, (next - inside) / disc_area});
    inside = next;
  }
}

int RingVolumes::find(const Eigen::Vector2d& point) const {
  const double distance = (point - centre_).norm();
  if (distance < edges_.front() || distance >= edges_.back()) return -1;
  return static_cast<int>(std::upper_bound(edges_.begin(), edges_.end(), distance) - edges_.begin()) - 1;
}

std::unique_ptr<const PointShares> RingVolumes::point_shares(std::shared_ptr<const Kernel> kernel) const {
  return std::make_unique<const RingKernel>(*kernel, centre_, edges_);
}

std::vector<Column> RingVolumes::columns() const {
  return {{"r_inner", "m", "-", "inner radius of the ring"},
          {"r_outer", "m", "-", "outer radius of the ring"},
          {"r", "m", "-", "mean of both"}};
}

Rows RingVolumes::coordinates() const {
  Rows rows(count(), 3);
  for (int i = 0; i < count(); ++i) {
    const double inner = edges_[static_cast<std::size_t>(i)];
    const double outer = edges_[static_cast<std::size_t>(i) + 1];
    rows.row(i) << inner, outer, 0.5 * (inner + outer);
  }
  return rows;
}

}  // namespace mikromakro
