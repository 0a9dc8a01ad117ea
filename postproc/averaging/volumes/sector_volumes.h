// SPDX-License-Identifier: GPL-2.0-or-later
// Rings around a centre, divided into sectors.
#pragma once

#include <memory>

#include "averaging/volumes/ring_volumes.h"

namespace mikromakro {

/// Each ring of `rings` divided at the angles 2 pi m/M, m = 0 ... M, counter-clockwise from the x direction;
/// index k M + m in ring k. Uses the polar basis of the rings. Throws (bad input) unless M >= 1.
class SectorVolumes : public Volumes {
 public:
  SectorVolumes(std::unique_ptr<const RingVolumes> rings, int sectors);

  int count() const override { return rings_->count() * sectors_; }
  double height() const override { return rings_->height(); }
  Eigen::ArrayXd measure() const override;
  Axes axes() const override { return rings_->axes(); }
  Eigen::Matrix2d basis(const Eigen::Vector2d& point) const override { return rings_->basis(point); }
  Box bounds() const override { return rings_->bounds(); }
  void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const override;
  int find(const Eigen::Vector2d& point) const override;
  std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const override;
  std::vector<Column> columns() const override;
  Rows coordinates() const override;

  const RingVolumes& rings() const { return *rings_; }
  /// Angle at which a sector begins (rad, from the x direction); any number of turns, -1 is the last sector.
  double angle(int sector) const;
  /// Half-open range of sector indices, possibly wrapped, spanning at most one turn.
  struct SectorRange {
    int first;
    int last;
  };
  /// The sectors that a disc overlaps, from the direction and distance of its centre relative to that of the
  /// rings; all of them if it covers the centre.
  SectorRange sectors_near(double direction, double distance, double radius) const;

 private:
  std::unique_ptr<const RingVolumes> rings_;
  int sectors_;
};

}  // namespace mikromakro
