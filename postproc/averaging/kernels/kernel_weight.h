// SPDX-License-Identifier: GPL-2.0-or-later
// Coarse-graining kernels as weights.
#pragma once

#include <memory>
#include <string>

#include "averaging/kernels/kernel.h"
#include "averaging/weight.h"

namespace mikromakro {

/// The field coarse-grained with a kernel W (unit integral over the plane), averaged over each volume:
///   w^p = integral over V of W(x - x_p) dA,
/// so that sums w^p V^p Q^p/V are averages of sum_p W(x - x_p) V^p Q^p. A contact whose force is carried by a
/// branch b counts with the line integral int_0^1 w(x_p + s b) ds, where w is the share of a point; the
/// divergence of the stress then balances the contact forces (Goldhirsch2010, Weinhart2012). The line
/// integral uses five Gauss-Legendre points on each Kernel::branch_piece: to 1e-8.
class KernelWeight : public Weight {
 public:
  explicit KernelWeight(std::unique_ptr<const Kernel> kernel) : kernel_(std::move(kernel)) {}
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
  bool is_kernel() const override { return true; }

 private:
  std::shared_ptr<const Kernel> kernel_;
};

/// 1/(pi W^2) within the distance W: shares of points are exact areas. Discontinuous, so line integrals (five
/// points on pieces of W/2) are accurate to 1e-4 only.
class TopHatWeight : public Weight {
 public:
  explicit TopHatWeight(double radius) : radius_(radius) {}
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
  bool is_kernel() const override { return true; }

 private:
  double radius_;
};

/// From a name such as gauss:0.004; null if the name is not that of a kernel. Throws if it is, but the width
/// is missing, not a number or not above 0.
std::unique_ptr<const Weight> make_kernel_weight(const std::string& name);

}  // namespace mikromakro
