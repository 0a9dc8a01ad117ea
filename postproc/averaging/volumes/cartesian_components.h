// SPDX-License-Identifier: GPL-2.0-or-later
// Rings and sectors with Cartesian components.
#pragma once

#include <memory>
#include <utility>

#include "averaging/volumes/volumes.h"

namespace mikromakro {

/// The same volumes, with vectors and tensors in the directions x and y at every point: averages are those of
/// the Cartesian components, which are no rotated averages of polar ones unless the volume is small. No
/// sequence of rings, since derivatives along r have no meaning for these components.
class CartesianComponents : public Volumes {
 public:
  explicit CartesianComponents(std::unique_ptr<const Volumes> volumes) : volumes_(std::move(volumes)) {}

  int count() const override { return volumes_->count(); }
  double height() const override { return volumes_->height(); }
  Eigen::ArrayXd measure() const override { return volumes_->measure(); }
  Axes axes() const override { return {"x", "y"}; }
  Eigen::Matrix2d basis(const Eigen::Vector2d& /*point*/) const override {
    return Eigen::Matrix2d::Identity();
  }
  Box bounds() const override { return volumes_->bounds(); }
  void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const override {
    volumes_->slice(centre, radius, shares);
  }
  int find(const Eigen::Vector2d& point) const override { return volumes_->find(point); }
  std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const override {
    return volumes_->point_shares(std::move(kernel));
  }
  std::vector<Column> columns() const override { return volumes_->columns(); }
  Rows coordinates() const override { return volumes_->coordinates(); }

 private:
  std::unique_ptr<const Volumes> volumes_;
};

}  // namespace mikromakro
