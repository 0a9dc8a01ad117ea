// SPDX-License-Identifier: GPL-2.0-or-later
// How far the geometry of a row may be from that of the discs it names: as far as the digits of the files go.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"

namespace mikromakro {

/// Measured for a frame, on some of its numbers. No tolerance is larger than a twentieth of a radius,
/// however few digits there are: a file that tells no more does not tell who touches whom.
class ContactTolerance {
 public:
  /// `place_error`: what the coordinates of the discs have lost (m); nan where it shall be seen from them.
  ContactTolerance(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box,
                   double place_error);

  /// Of a coordinate of a disc in a row, m.
  double of_place(double radius) const {
    return std::min(disc_place_ + row_place_, largest_part_of_radius * radius);
  }
  /// Of a distance, an overlap, and a normal times a distance, m. `told`: the overlap or the distance that
  /// the row tells, nan for none; `by_row`: places of the row are in it.
  double of_geometry(double smaller_radius, double reach, double told, bool by_row) const {
    const double rounding = distance_ + (by_row ? 3 * row_place_ : 0) + normal_ * reach +
                            (std::isnan(told) ? 0 : overlap_ * std::abs(told));
    return std::min(rounding, largest_part_of_radius * smaller_radius);
  }
  /// Whether the places of the discs are told better than those of the rows.
  bool discs_are_better() const { return disc_place_ < row_place_; }

 private:
  static constexpr double largest_part_of_radius = 0.05;

  double disc_place_, row_place_;
  double distance_;
  double normal_, overlap_;  // relative
};

}  // namespace mikromakro
