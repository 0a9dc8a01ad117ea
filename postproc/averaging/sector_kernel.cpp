#include "averaging/sector_kernel.h"

#include <algorithm>
#include <cmath>

#include "averaging/sector_volumes.h"

namespace mikromakro {
namespace {

// The kernel as the sides of sectors see it: lengths by its width, angles from the direction of its centre.
struct Seen {
  const Kernel& kernel;
  double distance;

  double along_arc(double R, double begin, double end) const {
    return arc_part(kernel, distance, R, begin, end);
  }
  // Outward along the straight side at an angle; the centre is on its left where the angle is negative.
  double along_side(double angle, double inner, double outer) const {
    const double half = std::sin(0.5 * angle);
    const double foot = distance * (1 - 2 * half * half);
    return kernel.line_part(-distance * std::sin(angle), inner - foot, outer - foot);
  }
};

}  // namespace

void SectorKernel::add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const {
  const RingVolumes& rings = volumes_.rings();
  const int sectors = volumes_.count() / rings.count();
  const Eigen::Vector2d arm = point - rings.centre();
  const double width = kernel_->width();
  const double reach = kernel_->reach() * width;
  const Seen seen{*kernel_, arm.norm() / width};
  const double direction = std::atan2(arm[1], arm[0]);
  const auto [first, last] = volumes_.sectors_near(direction, arm.norm(), reach);
  const std::vector<double>& edges = rings.edges();
  auto edge = std::upper_bound(edges.begin() + 1, edges.end(), arm.norm() - reach) - 1;
  const auto arcs_at = [&, first = first, last = last](double R, std::vector<double>& arcs) {
    arcs.clear();
    for (int i = first; i < last; ++i)
      arcs.push_back(
          seen.along_arc(R / width, volumes_.angle(i) - direction, volumes_.angle(i + 1) - direction));
  };
  std::vector<double> inner;
  std::vector<double> outer;
  if (edge + 1 != edges.end()) arcs_at(*edge, inner);
  for (; edge + 1 != edges.end() && *edge < arm.norm() + reach; ++edge) {
    arcs_at(edge[1], outer);
    const auto side = [&](int sector) {
      return seen.along_side(volumes_.angle(sector) - direction, edge[0] / width, edge[1] / width);
    };
    const double begin = side(first);
    double right = begin;
    for (int i = first; i < last; ++i) {
      // A whole turn comes back to the same side.
      const double left = i + 1 - first == sectors ? begin : side(i + 1);
      const auto arc = static_cast<std::size_t>(i - first);
      const double share = outer[arc] - inner[arc] + right - left;
      const int sector = (i % sectors + sectors) % sectors;
      const int ring = static_cast<int>(edge - edges.begin());
      if (share > smallest_share) shares.add(ring * sectors + sector, factor * share);
      right = left;
    }
    inner.swap(outer);
  }
}

}  // namespace mikromakro
