// SPDX-License-Identifier: GPL-2.0-or-later
// Rates of deformation and rotation from the mean velocity in rings (Latzel2001 Eqs. 6-8).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// D_rphi = (dv_phi/dr - v_phi/r)/2, W_rphi = (dv_phi/dr + v_phi/r)/2 (Latzel2001 Eqs. 7, 8), omega_excess =
/// omega - W_rphi (Latzel2001 Bild 11), 1/s. dv_phi/dr is the slope of the parabola through v_phi of the ring
/// and its two neighbours; the first and last rings use their two nearest rings. Exact for parabolas, second
/// order for rings of any width. Two rings share one slope. nan for a single ring, next to rings without
/// discs, and if the volumes are not rings.
class VelocityGradient : public Field {
 public:
  explicit VelocityGradient(bool over_rings = true) : over_rings_(over_rings) {}

  std::string_view name() const override { return "velocity_gradient"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {"velocity", "spin"}; }
  std::string_view missing_option() const override {
    return over_rings_ ? "" : "--rings with polar components, without --sectors";
  }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  bool over_rings_;
};

/// dv/dr at each point, as above; r must ascend.
Eigen::ArrayXd slopes(const Eigen::ArrayXd& r, const Eigen::ArrayXd& v);

}  // namespace mikromakro
