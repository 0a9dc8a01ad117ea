// SPDX-License-Identifier: GPL-2.0-or-later
// Rings around a centre, divided into sectors.
#pragma once

#include <memory>

#include "averaging/volumes/ring_volumes.h"

namespace mikromakro {

/// Each ring of `rings` divided at the angles 2 pi m/M, m = 0 ... M, counter-clockwise from the x direction;
/// number k M + m in ring k. The polar basis of the rings. Throws (bad input) unless M >= 1.
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
  /// Where a sector begins (rad, from the x direction); for any number of turns, -1 is the last one.
  double angle(int sector) const;
  /// Numbers over any number of turns, at most a turn: from the first to before the last.
  struct SectorRange {
    int first;
    int last;
  };
  /// The sectors that a disc reaches into, given the direction and the distance of its centre from that of
  /// the rings; all of them around the centre.
  SectorRange sectors_near(double direction, double distance, double radius) const;

 private:
  std::unique_ptr<const RingVolumes> rings_;
  int sectors_;
};

}  // namespace mikromakro
