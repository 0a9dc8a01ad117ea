// SPDX-License-Identifier: GPL-2.0-or-later
// Rates of deformation and rotation from the exponential fit to the mean velocity (Latzel2001 Eq. 9).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// D_rphi = -v/2 (1/s + 1/r), W_rphi = -v/2 (1/s - 1/r), 1/s, with v = v0 exp(-(r - R)/s) fitted to v_phi of
/// all rings with equal weights (Latzel2001 Eq. 9 and the sentence after it). nan if the volumes are not
/// rings or if no decaying exponential fits.
class VelocityGradientFit : public Field {
 public:
  explicit VelocityGradientFit(bool over_rings = true) : over_rings_(over_rings) {}

  std::string_view name() const override { return "velocity_gradient_fit"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {"velocity"}; }
  std::string_view missing_option() const override {
    return over_rings_ ? "" : "--rings with polar components, without --sectors";
  }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  bool over_rings_;
};

}  // namespace mikromakro
