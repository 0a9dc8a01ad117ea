// SPDX-License-Identifier: GPL-2.0-or-later
// Tolerance between the geometry of a row and that of its discs, from the number of digits in the files.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"

namespace mikromakro {

/// Estimated per frame from a sample of its numbers. No tolerance exceeds a twentieth of a radius, however
/// few the digits: a less precise file does not determine which discs touch.
class ContactTolerance {
 public:
  /// `place_error`: rounding error of the disc coordinates (m); nan: inferred from their digits.
  ContactTolerance(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box,
                   double place_error);

  /// Tolerance of a disc coordinate given in a row, m.
  double of_place(double radius) const {
    return std::min(disc_place_ + row_place_, largest_part_of_radius * radius);
  }
  /// Tolerance of a distance, an overlap, or a normal times a distance, m. `told`: overlap or distance given
  /// in the row, nan if none; `by_row`: the compared value is computed from the positions in the row.
  double of_geometry(double smaller_radius, double reach, double told, bool by_row) const {
    const double rounding = distance_ + (by_row ? 3 * row_place_ : 0) + normal_ * reach +
                            (std::isnan(told) ? 0 : overlap_ * std::abs(told));
    return std::min(rounding, largest_part_of_radius * smaller_radius);
  }
  /// Whether the disc positions are more precise than those in the rows.
  bool discs_are_better() const { return disc_place_ < row_place_; }

 private:
  static constexpr double largest_part_of_radius = 0.05;

  double disc_place_, row_place_;
  double distance_;
  double normal_, overlap_;  // relative
};

}  // namespace mikromakro
