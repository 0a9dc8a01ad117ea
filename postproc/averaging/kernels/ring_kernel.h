// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of points in rings.
#pragma once

#include <vector>

#include "averaging/kernels/kernel.h"
#include "averaging/kernels/piecewise_polynomial.h"
#include "averaging/shares.h"

namespace mikromakro {

/// Integral of a kernel about a point over each of the rings between successive `edges` (m, ascending from 0
/// or more) around `centre`, from one table over the distance per edge; to 1e-10. Throws (bad input) for more
/// than 10000 rings, since each takes 2 kB.
class RingKernel : public PointShares {
 public:
  RingKernel(const Kernel& kernel, const Eigen::Vector2d& centre, std::vector<double> edges);
  void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const override;

 private:
  double within(std::size_t edge, double distance) const;

  Eigen::Vector2d centre_;
  std::vector<double> edges_;
  double reach_;                              // m
  std::vector<PiecewisePolynomial> circles_;  // fraction inside each edge, by the distance in m
};

}  // namespace mikromakro
