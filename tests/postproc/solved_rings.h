// SPDX-License-Identifier: GPL-2.0-or-later
// Fields that are made from the velocities of rings, without a frame.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Columns of a field whose numbers are (v_r, v_phi, spin) of rings at r.
inline Rows solve_rings(const Field& field, const Eigen::ArrayXd& r, const Eigen::ArrayXd& v, int columns) {
  Rows numbers = Rows::Zero(r.size(), 3);
  numbers.col(1) = v;
  numbers.col(2) = 0.5;
  Rows solved(r.size(), columns);
  field.solve({r, 1, r}, numbers, solved);
  return solved;
}

}  // namespace mikromakro
