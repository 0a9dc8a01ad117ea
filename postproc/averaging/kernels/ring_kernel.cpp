// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/ring_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "averaging/kernels/circle_sweep.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr std::size_t most_rings = 10000;
constexpr double piece_of_smooth_length = 0.5;

PiecewisePolynomial circle_table(const Kernel& kernel, double R) {
  const double reach = kernel.reach() * kernel.width();
  std::vector<double> breaks = {std::max(R - reach, 0.0), R, R + reach};
  // The circle may fit entirely within the kernel.
  if (R < reach && reach - R != R) breaks.push_back(reach - R);
  std::sort(breaks.begin(), breaks.end());
  if (R == 0) breaks = {0, reach};
  const double width = kernel.width();
  return {[&](double d) { return CircleSweep(kernel, d / width, R / width).whole(); }, breaks,
          piece_of_smooth_length * kernel.smooth_length() * width};
}

}  // namespace

RingKernel::RingKernel(const Kernel& kernel, const Eigen::Vector2d& centre, std::vector<double> edges)
    : centre_(centre), edges_(std::move(edges)), reach_(kernel.reach() * kernel.width()) {
  if (edges_.size() > most_rings + 1)
    throw bad_input({"--weight"}, "too many rings for a kernel", fmt::format("{} or fewer", most_rings),
                    fmt::format("{}", edges_.size() - 1));
  circles_.reserve(edges_.size());
  for (const double edge : edges_) circles_.push_back(circle_table(kernel, edge));
}

double RingKernel::within(std::size_t edge, double distance) const {
  if (distance - edges_[edge] >= reach_) return 0;
  if (edges_[edge] - distance >= reach_) return 1;
  return circles_[edge](distance);
}

void RingKernel::add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const {
  const double distance = (point - centre_).norm();
  const auto first = std::upper_bound(edges_.begin() + 1, edges_.end(), distance - reach_);
  if (first == edges_.end()) return;
  auto edge = static_cast<std::size_t>(first - edges_.begin());
  double inside = within(edge - 1, distance);
  for (; edge < edges_.size() && inside < 1; ++edge) {
    const double next = within(edge, distance);
    if (!(next > inside)) continue;
    shares.add(static_cast<int>(edge) - 1, factor * (next - inside));
    inside = next;
  }
}

}  // namespace mikromakro
