// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of positions in given volumes.
#pragma once

#include <Eigen/Core>

#include "averaging/share_sums.h"

namespace mikromakro {

/// A weight applied to given volumes. Each function appends to `shares`, which must be empty; shares are
/// dimensionless. No member throws.
class Shares {
 public:
  Shares() = default;
  Shares(const Shares&) = delete;
  Shares& operator=(const Shares&) = delete;
  virtual ~Shares() = default;

  /// Distance from its centre (m) within which a disc of this radius may count.
  virtual double reach(double radius) const = 0;
  /// w^p of Latzel2001 Eq. 4 for a disc.
  virtual void of_disc(const Eigen::Vector2d& centre, double radius, ShareSums& shares) const = 0;

  /// Whether points and branches have their own shares. If not, contacts count where their disc does, and the
  /// functions below must not be called.
  virtual bool of_places() const { return false; }
  virtual void of_point(const Eigen::Vector2d& /*point*/, ShareSums& /*shares*/) const {}
  /// Mean share of the points between `from` and `from + branch`.
  virtual void of_branch(const Eigen::Vector2d& /*from*/, const Eigen::Vector2d& /*branch*/,
                         ShareSums& /*shares*/) const {}
};

/// Shares of points.
class PointShares {
 public:
  PointShares() = default;
  PointShares(const PointShares&) = delete;
  PointShares& operator=(const PointShares&) = delete;
  virtual ~PointShares() = default;

  /// Adds `factor` times the point's share in each volume.
  virtual void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const = 0;
};

}  // namespace mikromakro
