// SPDX-License-Identifier: GPL-2.0-or-later
// Rates of deformation and rotation of the mean velocity in rings (Latzel2001 Eqs. 6-8).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// D_rphi = (dv_phi/dr - v_phi/r)/2, W_rphi = (dv_phi/dr + v_phi/r)/2 (Latzel2001 Eqs. 7, 8), omega_excess =
/// omega
/// - W_rphi (Latzel2001 Bild 11), 1/s. dv_phi/dr is the slope of the parabola through v_phi of the ring and
/// both neighbours, at the ends of the ring and its two nearest: exact for parabolas, of order 2 for rings of
/// any width. Two rings have one slope. nan for one ring, beside rings without discs, and where the volumes
/// are no rings.
class VelocityGradient : public Field {
 public:
  explicit VelocityGradient(bool over_rings = true) : over_rings_(over_rings) {}

  std::string_view name() const override { return "velocity_gradient"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {"velocity", "spin"}; }
  std::string_view missing_option() const override { return over_rings_ ? "" : "--rings without --sectors"; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  bool over_rings_;
};

/// dv/dr at each point as above; r ascends.
Eigen::ArrayXd slopes(const Eigen::ArrayXd& r, const Eigen::ArrayXd& v);

}  // namespace mikromakro
