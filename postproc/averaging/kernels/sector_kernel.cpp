// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/sector_kernel.h"

#include <algorithm>
#include <cmath>

#include "averaging/kernels/circle_sweep.h"
#include "averaging/volumes/sector_volumes.h"

namespace mikromakro {
namespace {

// A straight side relative to the kernel, in kernel widths: the distance at which the line passes with the
// centre on its left, and the distance from the rings' centre to the point nearest to the kernel's centre.
struct Line {
  double h;
  double foot;

  Line(double distance, double angle) {
    const double half = std::sin(0.5 * angle);
    h = -distance * std::sin(angle);
    foot = distance * (1 - 2 * half * half);
  }
  double part(const Kernel& kernel, double inner, double outer) const {
    return kernel.line_part(h, inner - foot, outer - foot);
  }
};

}  // namespace

void SectorKernel::add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const {
  const RingVolumes& rings = volumes_.rings();
  const int sectors = volumes_.count() / rings.count();
  const Eigen::Vector2d arm = point - rings.centre();
  const double width = kernel_->width();
  const double reach = kernel_->reach() * width;
  const double distance = arm.norm();
  const double direction = std::atan2(arm[1], arm[0]);
  const auto [first, last] = volumes_.sectors_near(direction, distance, reach);
  const auto count = static_cast<std::size_t>(last - first);
  // Angles from the direction of the kernel's centre, and the sides at these angles.
  std::vector<double> angles;
  std::vector<Line> lines;
  for (int i = first; i <= last; ++i) {
    angles.push_back(volumes_.angle(i) - direction);
    // After a full turn it is the same side again.
    lines.emplace_back(i - first == sectors ? lines.front() : Line(distance / width, angles.back()));
  }
  const std::vector<double>& edges = rings.edges();
  auto edge = std::upper_bound(edges.begin() + 1, edges.end(), distance - reach) - 1;
  const auto arcs_at = [&](double R, std::vector<double>& arcs) {
    const CircleSweep circle(*kernel_, distance / width, R / width);
    for (std::size_t i = 0; i < count; ++i) arcs[i] = circle.arc(angles[i], angles[i + 1]);
  };
  std::vector<double> inner(count);
  std::vector<double> outer(count);
  if (edge + 1 != edges.end()) arcs_at(*edge, inner);
  for (; edge + 1 != edges.end() && *edge < distance + reach; ++edge) {
    arcs_at(edge[1], outer);
    const int ring = static_cast<int>(edge - edges.begin());
    double right = lines[0].part(*kernel_, edge[0] / width, edge[1] / width);
    for (std::size_t i = 0; i < count; ++i) {
      const double left = lines[i + 1].part(*kernel_, edge[0] / width, edge[1] / width);
      const double share = outer[i] - inner[i] + right - left;
      const int sector = ((first + static_cast<int>(i)) % sectors + sectors) % sectors;
      if (share > smallest_share) shares.add(ring * sectors + sector, factor * share);
      right = left;
    }
    inner.swap(outer);
  }
}

}  // namespace mikromakro
