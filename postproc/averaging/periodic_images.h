// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic images of discs and contacts.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// The periodic images of positions that matter in a part of the plane: position + (k_x L_x, k_y L_y), with k
/// any integer along periodic axes and 0 along the others. The position itself may lie outside the box.
class PeriodicImages {
 public:
  /// `part` is the rectangle of interest; its own periodic flags are ignored.
  PeriodicImages(const Box& box, const Box& part);

  /// Whether there are images other than the positions themselves.
  bool any() const { return any_; }

  /// Replaces `images` by all that are within `reach` (m) of the part along both axes. With a reach of 0,
  /// these are the images with low <= coordinate < high: exactly m if the part is m periods long, despite
  /// rounding. Along a non-periodic axis only the position itself counts, wherever it lies. Throws (bad
  /// input) for more than 10,000 images.
  void of(const Eigen::Vector2d& place, double reach, std::vector<Eigen::Vector2d>& images) const {
    images.clear();
    if (any_) {
      add(place, reach, images);
    } else {
      images.push_back(place);
    }
  }

 private:
  // Image k is at first + k period, begin <= k < end.
  struct Row {
    double first;
    double begin;
    double end;
  };
  struct Axis {
    double low;
    double high;
    double period;  // 0: not periodic
    double whole;   // periods from low to high; 0 if not an integer

    Row row(double x, double reach) const;
    double coordinate(const Row& row, double k, double reach) const;
  };

  static Axis axis_of(const Box& box, const Box& part, Eigen::Index axis);
  void add(const Eigen::Vector2d& place, double reach, std::vector<Eigen::Vector2d>& images) const;

  Axis x_;
  Axis y_;
  bool any_;
};

}  // namespace mikromakro
