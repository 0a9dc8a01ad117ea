// SPDX-License-Identifier: GPL-2.0-or-later
// Rings around a centre.
#pragma once

#include "averaging/volumes/volumes.h"

namespace mikromakro {

/// Rings edges[k] <= r < edges[k+1] around `centre` (m), with the polar basis (e_r, e_phi) at each point; at
/// the centre e_r is the x direction. Throws (bad input) on fewer than two edges, edges that do not increase
/// from 0 or more, and height <= 0.
class RingVolumes : public Volumes {
 public:
  RingVolumes(const Eigen::Vector2d& centre, std::vector<double> edges, double height);

  int count() const override { return static_cast<int>(edges_.size()) - 1; }
  double height() const override { return height_; }
  Eigen::ArrayXd measure() const override;
  Axes axes() const override { return {"r", "phi"}; }
  Eigen::Matrix2d basis(const Eigen::Vector2d& point) const override;
  Box bounds() const override {
    return {centre_.array() - edges_.back(), centre_.array() + edges_.back(), {}};
  }
  Eigen::ArrayXd radii() const override;
  void slice(const Eigen::Vector2d& centre, double radius, std::vector<Share>& shares) const override;
  int find(const Eigen::Vector2d& point) const override;
  std::unique_ptr<const PointShares> point_shares(std::shared_ptr<const Kernel> kernel) const override;
  std::vector<Column> columns() const override;
  Rows coordinates() const override;

  const Eigen::Vector2d& centre() const { return centre_; }
  const std::vector<double>& edges() const { return edges_; }

 private:
  Eigen::Vector2d centre_;
  std::vector<double> edges_;
  double height_;
};

/// Edges of `count` equal rings from `inner` to `outer` (m). Throws unless 0 <= inner < outer and count >= 1.
std::vector<double> equal_ring_edges(double inner, double outer, int count);

}  // namespace mikromakro
