// SPDX-License-Identifier: GPL-2.0-or-later
// Errors of columns that are not linear in the sums: lengths (deviators), directions, quotients, covariances.
#pragma once

#include <string>
#include <vector>

#include "fields/field.h"

namespace mikromakro {

/// A column without errors, because it bends too much over the range of its error.
struct CurvedColumn {
  std::string name;
  double frames_needed = 0;  ///< relative to those that there are
};

struct NonlinearErrors {
  std::vector<CurvedColumn> curved;
  Eigen::Index undirected = 0;  ///< directions without an error, because their deviator is too small
};

/// Corrects the errors `error` of one field (volumes x columns) that hold to first order; `values` are its
/// columns, `curvature` their second-order term at one standard error (pseudo_values.h).
///
/// - Lengths (Column::length) are too large where the vector is insignificant, since they are positive: by
/// 1.25 standard errors for an isotropic tensor. Twice the curvature is added to the error by squares, with
/// which errors cover 63 and 92 % for isotropic tensors, 68 and 95 % or more otherwise. None is withheld:
/// whatever depends on the value would select those that are too large.
/// - A direction, the column after its length L, has an error only if L exceeds four of its errors e, else
/// nan. The errors of L and of the direction are those of two components, nearly independent: a limit on the
/// error of the direction itself would select those that are underestimated. Lengths selected are on average
/// larger than their true values and their directions vary more than the error says: it is multiplied by
/// (1 + 8 (e/L)^2)^0.5.
/// - In other columns twice the curvature is added, too, and must be small: its square relative to that of
/// the error has a median over the volumes of at most 1/16/(1 + 8/volumes), else no volume has an error.
/// Quotients with a fluctuating denominator are an example: small values have small errors, so that a
/// decision by the value itself would select those. The fewer volumes, the more the median depends on them.
NonlinearErrors correct_nonlinear(const ColumnsOfField& field, const ConstRowsRef& values,
                                  const ConstRowsRef& curvature, RowsRef error);

}  // namespace mikromakro
