// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/volumes/sector_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "averaging/kernels/sector_kernel.h"
#include "averaging/volumes/disc_corner_area.h"
#include "model/error.h"

namespace mikromakro {

SectorVolumes::SectorVolumes(std::unique_ptr<const RingVolumes> rings, int sectors)
    : rings_(std::move(rings)), sectors_(sectors) {
  if (sectors < 1)
    throw bad_input({"--sectors"}, "no sectors", "a whole number M of 1 or more", fmt::format("{}", sectors));
}

double SectorVolumes::angle(int sector) const {
  return 2 * std::numbers::pi * sector / sectors_;
}

Eigen::ArrayXd SectorVolumes::measure() const {
  const Eigen::ArrayXd of_rings = rings_->measure();
  Eigen::ArrayXd measure(count());
  for (int i = 0; i < count(); ++i) measure[i] = of_rings[i / sectors_] / sectors_;
  return measure;
}

SectorVolumes::SectorRange SectorVolumes::sectors_near(double direction, double distance,
                                                       double radius) const {
  constexpr double rounding = 1e-12;  // of the angles
  const double half = distance > radius ? std::asin(radius / distance) + rounding : std::numbers::pi;
  const int first = static_cast<int>(std::floor((direction - half) / angle(1)));
  const int last = static_cast<int>(std::floor((direction + half) / angle(1))) + 1;
  return {first, std::min(last, first + sectors_)};
}

void SectorVolumes::slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const {
  const std::vector<double>& edges = rings_->edges();
  const Eigen::Vector2d arm = centre - rings_->centre();
  const double distance = arm.norm();
  const double direction = std::atan2(arm[1], arm[0]);
  const double area = std::numbers::pi * radius * radius;
  const auto [first, last] = sectors_near(direction, distance, radius);
  // Fraction of the disc inside a ring's edge, from an arbitrary direction up to the beginning of a sector.
  const auto corner = [&, first = first](double edge, int sector) {
    // A full turn uses the same line again, rather than one whose angle is rounded differently.
    const bool turned = sector - first == sectors_;
    const double delta = angle(turned ? first : sector) - direction;
    const double turn = turned ? disc_circle_area(distance, radius, edge) : 0;
    return (sector_corner(distance, radius, edge, delta) + turn) / area;
  };
  auto edge = std::upper_bound(edges.begin() + 1, edges.end(), distance - radius) - 1;
  std::vector<double> within(static_cast<std::size_t>(last - first) + 1);
  for (int i = first; i <= last; ++i) within[static_cast<std::size_t>(i - first)] = corner(*edge, i);
  for (; edge + 1 != edges.end() && *edge < distance + radius; ++edge) {
    const int ring = static_cast<int>(edge - edges.begin());
    double before = 0;
    for (int i = first; i <= last; ++i) {
      const double outer = corner(edge[1], i);
      const double next = outer - std::exchange(within[static_cast<std::size_t>(i - first)], outer);
      const int sector = ((i - 1) % sectors_ + sectors_) % sectors_;
      if (i > first && next - before > smallest_share)
        shares.push_back({ring * sectors_ + sector, next - before});
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
  // Decide by the angles of the edges, not by the rounded quotient.
  if (sector > 0 && direction < angle(sector)) --sector;
  if (sector < sectors_ - 1 && direction >= angle(sector + 1)) ++sector;
  return ring * sectors_ + sector;
}

std::unique_ptr<const PointShares> SectorVolumes::point_shares(std::shared_ptr<const Kernel> kernel) const {
  return std::make_unique<const SectorKernel>(std::move(kernel), *this);
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
