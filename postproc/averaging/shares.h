// SPDX-License-Identifier: GPL-2.0-or-later
// How places count in certain volumes.
#pragma once

#include <Eigen/Core>

#include "averaging/share_sums.h"

namespace mikromakro {

/// What a weight makes of certain volumes. Each function appends to `shares`, which is empty; shares are
/// dimensionless. None of them throws.
class Shares {
 public:
  Shares() = default;
  Shares(const Shares&) = delete;
  Shares& operator=(const Shares&) = delete;
  virtual ~Shares() = default;

  /// The distance from its centre (m) at which a disc of this radius may still count.
  virtual double reach(double radius) const = 0;
  /// w^p of Latzel2001 Eq. 4 of a disc.
  virtual void of_disc(const Eigen::Vector2d& centre, double radius, ShareSums& shares) const = 0;

  /// Whether points and branches have shares of their own. Otherwise contacts count as their disc does, and
  /// the following functions must not be called.
  virtual bool of_places() const { return false; }
  virtual void of_point(const Eigen::Vector2d& /*point*/, ShareSums& /*shares*/) const {}
  /// Mean of the shares of the points between `from` and `from + branch`.
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

  /// Adds `factor` times the point's share of each volume.
  virtual void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const = 0;
};

}  // namespace mikromakro
