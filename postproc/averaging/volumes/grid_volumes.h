// SPDX-License-Identifier: GPL-2.0-or-later
// Rectangles along x and y.
#pragma once

#include <string_view>

#include "averaging/volumes/volumes.h"

namespace mikromakro {

/// Rectangles x_edges[i] <= x < x_edges[i+1], y_edges[j] <= y < y_edges[j+1] (m), x varying fastest: index j
/// N_x + i; basis (e_x, e_y). Throws (bad input) on fewer than two edges, edges that do not increase, and
/// height <= 0.
class GridVolumes : public Volumes {
 public:
  GridVolumes(std::vector<double> x_edges, std::vector<double> y_edges, double height);

  int count() const override { return columns_of_cells() * rows_of_cells(); }
  double height() const override { return height_; }
  Eigen::ArrayXd measure() const override;
  Axes axes() const override { return {"x", "y"}; }
  Eigen::Matrix2d basis(const Eigen::Vector2d& /*point*/) const override {
    return Eigen::Matrix2d::Identity();
  }
  Box bounds() const override {
    return {{x_edges_.front(), y_edges_.front()}, {x_edges_.back(), y_edges_.back()}, {}};
  }
  void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const override;
  int find(const Eigen::Vector2d& point) const override;
  std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const override;
  std::vector<Column> columns() const override;
  Rows coordinates() const override;

 private:
  int columns_of_cells() const { return static_cast<int>(x_edges_.size()) - 1; }
  int rows_of_cells() const { return static_cast<int>(y_edges_.size()) - 1; }

  std::vector<double> x_edges_;
  std::vector<double> y_edges_;
  double height_;
};

/// Edges of `count` equal intervals from `low` to `high` (m). Throws, naming `option`, unless low < high,
/// both are finite, and count >= 1.
std::vector<double> equal_grid_edges(double low, double high, int count, std::string_view option);

}  // namespace mikromakro
