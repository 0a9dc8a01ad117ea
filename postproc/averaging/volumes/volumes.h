// SPDX-License-Identifier: GPL-2.0-or-later
// The volumes over which is averaged: one of the three independent choices (volumes, weight, fields).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "averaging/kernels/kernel.h"
#include "averaging/shares.h"
#include "fields/field.h"
#include "model/frame.h"

namespace mikromakro {

/// Parts of a disc below this are rounding and left out where areas come as differences of areas at corners.
inline constexpr double smallest_share = 4e-15;

/// A list of volumes of thickness h, each with an area, and the basis in which tensors are written.
class Volumes {
 public:
  Volumes() = default;
  Volumes(const Volumes&) = delete;
  Volumes& operator=(const Volumes&) = delete;
  virtual ~Volumes() = default;

  virtual int count() const = 0;
  /// Thickness h (m).
  virtual double height() const = 0;
  /// V = area * h (m^3) of each volume.
  virtual Eigen::ArrayXd measure() const = 0;
  virtual Axes axes() const = 0;
  /// Rotation whose rows are the two directions of the basis at a point (m).
  virtual Eigen::Matrix2d basis(const Eigen::Vector2d& point) const = 0;

  /// The smallest rectangle that holds all of them (m).
  virtual Box bounds() const = 0;

  /// Middle radius of each ring, ascending (m); empty where the volumes are not a sequence of rings.
  virtual Eigen::ArrayXd radii() const { return {}; }

  /// Appends the volumes that the disc touches, each once, with the part of its area in each.
  virtual void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const = 0;
  /// The volume that holds the point, -1 for none.
  virtual int find(const Eigen::Vector2d& point) const = 0;
  /// Integrals of a kernel around a point over each volume. The volumes must live as long as the result.
  virtual std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const = 0;

  /// Columns that tell where a volume lies, and their values.
  virtual std::vector<Column> columns() const = 0;
  virtual Rows coordinates() const = 0;
};

}  // namespace mikromakro
