// SPDX-License-Identifier: GPL-2.0-or-later
// Averaging volumes: one of the three independent choices (volumes, weight, fields).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "averaging/kernels/kernel.h"
#include "averaging/shares.h"
#include "fields/field.h"
#include "model/frame.h"

namespace mikromakro {

/// Smaller fractions of a disc are rounding errors and dropped where areas are differences of corner areas.
inline constexpr double smallest_share = 4e-15;

/// A list of volumes of thickness h, each with an area, and the basis in which tensors are expressed.
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
  /// Rotation whose rows are the two basis directions at a point (m).
  virtual Eigen::Matrix2d basis(const Eigen::Vector2d& point) const = 0;

  /// The bounding rectangle of all volumes (m).
  virtual Box bounds() const = 0;

  /// Middle radius of each ring, ascending (m); empty if the volumes are not a sequence of rings.
  virtual Eigen::ArrayXd radii() const { return {}; }

  /// Appends the volumes that the disc overlaps, each once, with the fraction of its area in each.
  virtual void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const = 0;
  /// The volume that contains the point, -1 if none does.
  virtual int find(const Eigen::Vector2d& point) const = 0;
  /// Integrals of a kernel about a point over each volume. The volumes must outlive the result.
  virtual std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const = 0;

  /// Columns that describe the position of a volume, and their values.
  virtual std::vector<Column> columns() const = 0;
  virtual Rows coordinates() const = 0;
};

}  // namespace mikromakro
