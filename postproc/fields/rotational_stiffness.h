// SPDX-License-Identifier: GPL-2.0-or-later
// Rotational stiffness (Latzel2001 Bild 12).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// mu_c = M.kappa/kappa.kappa, Pa: the least-squares ratio of couple stress to curvature over their two
/// components (the paper's 'quotient of the components', as one number). nan where kappa is 0 or undefined.
class RotationalStiffness : public Field {
 public:
  std::string_view name() const override { return "rotational_stiffness"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {"couple_stress", "curvature"}; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
