// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of points in sectors of rings.
#pragma once

#include <memory>
#include <vector>

#include "averaging/kernels/kernel.h"
#include "averaging/shares.h"

namespace mikromakro {

class SectorVolumes;

/// Integral of a kernel about a point over each sector, by quadrature along its sides (closed form along
/// straight sides if the kernel has one): to 1e-10. The volumes must outlive this object. Never throws.
class SectorKernel : public PointShares {
 public:
  SectorKernel(std::shared_ptr<const Kernel> kernel, const SectorVolumes& volumes)
      : kernel_(std::move(kernel)), volumes_(volumes) {}
  void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const override;

 private:
  std::shared_ptr<const Kernel> kernel_;
  const SectorVolumes& volumes_;
};

}  // namespace mikromakro
