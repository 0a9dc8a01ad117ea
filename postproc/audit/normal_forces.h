// SPDX-License-Identifier: GPL-2.0-or-later
// Normal forces between discs beside what their overlaps let expect.
#pragma once

#include "model/frame.h"

namespace mikromakro {

/// Sums over all contacts of two discs in the frames that were added; contacts with walls do not count, which
/// may be stiffer.
class NormalForces {
 public:
  /// `normal_stiffness` is k_n (N/m); nan: not known.
  explicit NormalForces(double normal_stiffness) : k_n_(normal_stiffness) {}

  void add(const Frame& frame);

  /// sum f_n over the sum of the overlaps, N/m: k_n under a linear law, whose dashpots add nothing on the
  /// average. nan without contacts.
  double stiffness() const { return force_ / overlap_; }
  /// sum |f_n - k_n overlap| over sum k_n overlap: 0 at rest under a linear law, 1 where all forces are
  /// doubled, 2 where all are reversed; dashpots scatter it. nan without contacts or k_n.
  double deviation() const { return deviation_ / (k_n_ * overlap_); }
  /// Part of sum |f_n| in contacts that pull. nan without forces.
  double pulling() const { return pulling_ / magnitude_; }
  bool stiffness_is_known() const { return k_n_ > 0; }

 private:
  double k_n_;
  double force_ = 0;
  double magnitude_ = 0;
  double pulling_ = 0;
  double overlap_ = 0;
  double deviation_ = 0;
};

}  // namespace mikromakro
