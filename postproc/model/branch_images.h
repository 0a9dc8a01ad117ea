// SPDX-License-Identifier: GPL-2.0-or-later
// Branch vectors across the periodic boundaries of the box.
#pragma once

#include <cmath>
#include <limits>

#include "model/frame.h"

namespace mikromakro {

/// The periodic images of a branch vector l (m): l + (k_x L_x, k_y L_y), with k any integer along periodic
/// axes and 0 along the others.
class BranchImages {
 public:
  explicit BranchImages(const Box& box) {
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      if (box.periodic[static_cast<std::size_t>(axis)] && box.length()[axis] > 0)
        length_[axis] = box.length()[axis];
    any_ = !length_.isZero();
  }

  /// Whether there are images other than the branch itself.
  bool any() const { return any_; }

  /// The shortest one.
  Eigen::Vector2d nearest(Eigen::Vector2d branch) const {
    if (!any_) return branch;
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      if (length_[axis] > 0) branch[axis] -= length_[axis] * std::round(branch[axis] / length_[axis]);
    return branch;
  }

  /// The image nearest to `wanted`.
  Eigen::Vector2d nearest_to(const Eigen::Vector2d& wanted, const Eigen::Vector2d& branch) const {
    return wanted + nearest(branch - wanted);
  }

  /// The shortest image other than the branch itself, which must lie in the box.
  Eigen::Vector2d nearest_other(const Eigen::Vector2d& branch) const {
    Eigen::Vector2d best(std::numeric_limits<double>::max(), 0);
    for (int along_x = -1; along_x <= 1; ++along_x)
      for (int along_y = -1; along_y <= 1; ++along_y) {
        const Eigen::Vector2d shift(along_x * length_.x(), along_y * length_.y());
        if (!shift.isZero() && (branch + shift).norm() < best.norm()) best = branch + shift;
      }
    return best;
  }

  /// Whether a second image, besides `nearest` (the shortest), is shorter than `reach`: the box is narrow.
  bool two_within(double reach, const Eigen::Vector2d& nearest) const {
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      if (length_[axis] > 0 && std::hypot(length_[axis] - std::abs(nearest[axis]), nearest[1 - axis]) < reach)
        return true;
    return false;
  }

  /// Whether two_within() can be true for any branch.
  bool several_within(double reach) const {
    return (length_.x() > 0 && length_.x() < 2 * reach) || (length_.y() > 0 && length_.y() < 2 * reach);
  }

  /// Visits the images shorter than `reach`, among `nearest` and two on each side of it; farther ones overlap
  /// only in boxes shorter than the radius.
  template <typename Visit>
  void visit_within(double reach, const Eigen::Vector2d& nearest, Visit visit) const {
    const int sides[] = {length_.x() > 0 ? 2 : 0, length_.y() > 0 ? 2 : 0};
    for (int along_x = -sides[0]; along_x <= sides[0]; ++along_x)
      for (int along_y = -sides[1]; along_y <= sides[1]; ++along_y) {
        const Eigen::Vector2d image = nearest + Eigen::Vector2d(along_x * length_.x(), along_y * length_.y());
        if (image.squaredNorm() < reach * reach) visit(image);
      }
  }

 private:
  Eigen::Vector2d length_ = Eigen::Vector2d::Zero();  // 0 along a non-periodic axis
  bool any_ = false;
};

}  // namespace mikromakro
