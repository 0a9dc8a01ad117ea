// SPDX-License-Identifier: GPL-2.0-or-later
// Trace, deviator and principal axes of a tensor field.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// For a tensor T of another field: tr_T; dev_T = T_max - T_min (not halved, Latzel2001 Bild 7 b and 8 b);
/// angle_T, the direction of the major axis, counter-clockwise from e_r in degrees, in (-90, 90]; the
/// principal values T_major and T_minor. All refer to the symmetric part. The major axis is that of the
/// largest compression for stress and strain, and that of the largest value for the fabric. The angle is nan
/// where T is isotropic.
class PrincipalAxes : public Field {
 public:
  /// The field that holds the tensor, its symbol in column names, and its unit.
  struct Tensor {
    std::string_view field_name;
    std::string_view source;
    std::string_view symbol;
    std::string_view unit;
    bool compression_negative;
  };
  explicit PrincipalAxes(const Tensor& tensor) : tensor_(tensor) {}

  std::string_view name() const override { return tensor_.field_name; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::vector<std::string_view> sources() const override { return {tensor_.source}; }
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  Tensor tensor_;
};

}  // namespace mikromakro
