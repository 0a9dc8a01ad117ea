#include "averaging/sector_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "averaging/disc_corner_area.h"
#include "io/error.h"

namespace mikromakro {

SectorVolumes::SectorVolumes(std::unique_ptr<const RingVolumes> rings, int sectors)
    : rings_(std::move(rings)), sectors_(sectors) {
  if (sectors < 1)
    throw bad_input({"--sectors"}, "no sectors", "a whole number M of 1 or more", fmt::format("{}", sectors));
}

// Any number of turns: -1 is the last one.
double SectorVolumes::angle(int sector) const {
  return 2 * std::numbers::pi * sector / sectors_;
}

Eigen::ArrayXd SectorVolumes::measure() const {
  const Eigen::ArrayXd of_rings = rings_->measure();
  Eigen::ArrayXd measure(count());
  for (int i = 0; i < count(); ++i) measure[i] = of_rings[i / sectors_] / sectors_;
  return measure;
}

// The sectors that a disc may touch, one more on either side against rounding; all of them around the centre.
// From the first to before the last, numbers over any number of turns.
SectorVolumes::SectorRange SectorVolumes::sectors_near(double direction, double distance,
                                                       double radius) const {
  const double half = distance > radius ? std::asin(radius / distance) : std::numbers::pi;
  const int first = static_cast<int>(std::floor((direction - half) / angle(1))) - 1;
  const int last = static_cast<int>(std::floor((direction + half) / angle(1))) + 2;
  return {first, std::min(last, first + sectors_)};
}

void SectorVolumes::slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const {
  const std::vector<double>& edges = rings_->edges();
  const Eigen::Vector2d arm = centre - rings_->centre();
  const double distance = arm.norm();
  const double direction = std::atan2(arm[1], arm[0]);
  const double area = std::numbers::pi * radius * radius;
  const auto [first, last] = sectors_near(direction, distance, radius);
  const auto corner = [&](std::size_t ring_edge, int sector) {
    // A whole turn comes back to the same line, not to one with an angle rounded otherwise.
    const bool turned = sector - first == sectors_;
    const double delta = angle(turned ? first : sector) - direction;
    const double turn = turned ? disc_circle_area(distance, radius, edges[ring_edge]) : 0;
    return (sector_corner(distance, radius, edges[ring_edge], delta) + turn) / area;
  };
  auto inner = std::upper_bound(edges.begin() + 1, edges.end(), distance - radius) - 1;
  for (; inner + 1 != edges.end() && *inner < distance + radius; ++inner) {
    const auto ring = static_cast<std::size_t>(inner - edges.begin());
    double before = corner(ring + 1, first) - corner(ring, first);
    for (int sector = first; sector < last; ++sector) {
      const double next = corner(ring + 1, sector + 1) - corner(ring, sector + 1);
      const int place = (sector % sectors_ + sectors_) % sectors_;
      if (next - before > smallest_share)
        shares.push_back({static_cast<int>(ring) * sectors_ + place, next - before});
      before = next;
    }
  }
}

int SectorVolumes::find(const Eigen::Vector2d& point) const {
  const int ring = rings_->find(point);
  if (ring < 0) return -1;
  const Eigen::Vector2d arm = point - rings_->centre();
  double direction = std::atan2(arm[1], arm[0]);
  if (direction < 0) direction += 2 * std::numbers::pi;
  int sector = std::min(static_cast<int>(direction / angle(1)), sectors_ - 1);
  // The angles of the edges decide, not the rounding of the quotient.
  if (sector > 0 && direction < angle(sector)) --sector;
  if (sector < sectors_ - 1 && direction >= angle(sector + 1)) ++sector;
  return ring * sectors_ + sector;
}

std::vector<Column> SectorVolumes::columns() const {
  std::vector<Column> columns = rings_->columns();
  columns.push_back({"phi_begin", "degree", "-", "where the sector begins, counter-clockwise from x"});
  columns.push_back({"phi_end", "degree", "-", "where it ends"});
  columns.push_back({"phi", "degree", "-", "mean of both"});
  return columns;
}

Rows SectorVolumes::coordinates() const {
  const Rows of_rings = rings_->coordinates();
  Rows rows(count(), of_rings.cols() + 3);
  for (int i = 0; i < count(); ++i) {
    const double begin = 360.0 * (i % sectors_) / sectors_;
    const double end = 360.0 * (i % sectors_ + 1) / sectors_;
    rows.row(i) << of_rings.row(i / sectors_), begin, end, 0.5 * (begin + end);
  }
  return rows;
}

}  // namespace mikromakro
