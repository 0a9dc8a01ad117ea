// SPDX-License-Identifier: GPL-2.0-or-later
// Normal forces between discs compared with those expected from the overlaps.
#pragma once

#include "model/frame.h"

namespace mikromakro {

/// Sums over all disc-disc contacts of the added frames. Contacts with walls, which may be stiffer, do not
/// count.
class NormalForces {
 public:
  /// `normal_stiffness`: k_n (N/m), nan if not known.
  explicit NormalForces(double normal_stiffness) : k_n_(normal_stiffness) {}

  void add(const Frame& frame);

  /// sum f_n over the sum of the overlaps, N/m: equals k_n for a linear law, as dashpots average out. nan
  /// without contacts.
  double stiffness() const { return force_ / overlap_; }
  /// sum |f_n - k_n overlap| over sum k_n overlap: 0 at rest for a linear law, 1 if all forces are doubled, 2
  /// if all are reversed; dashpots add scatter. nan without contacts or k_n.
  double deviation() const { return deviation_ / (k_n_ * overlap_); }
  /// Fraction of sum |f_n| in tensile contacts. nan without forces.
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
