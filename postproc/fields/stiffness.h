// SPDX-License-Identifier: GPL-2.0-or-later
// Stiffness and shear modulus (Latzel2001 3.6).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// E = tr sigma/tr eps and G = dev sigma/dev eps, in units of k_n/h if k_n is given, else in Pa. Latzel2001
/// plots 2 pi E h/k_n (Bild 9) and pi G h/k_n (Bild 10). For purely elastic normal forces, 2 pi E h/k_n = tr
/// F where the fabric is isotropic (docs/conventions.md). nan where the denominator is 0 or eps is undefined.
class Stiffness : public Field {
 public:
  explicit Stiffness(double normal_stiffness) : normal_stiffness_(normal_stiffness) {}

  std::string_view name() const override { return "stiffness"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {"stress", "elastic_strain"}; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  double normal_stiffness_;
};

}  // namespace mikromakro
