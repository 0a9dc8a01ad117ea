// SPDX-License-Identifier: GPL-2.0-or-later
// Where discs and contacts are once more: their images through the periodic boundaries of the box.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// The images of places that matter in a part of the plane: place + (k_x L_x, k_y L_y), k whole numbers along
/// the axes along which the box is periodic, 0 along others. The place itself may lie outside of the box.
class PeriodicImages {
 public:
  /// `part` is the rectangle in which something is looked at; its own flags do not matter.
  PeriodicImages(const Box& box, const Box& part);

  /// Whether there are others than the places themselves.
  bool any() const { return any_; }

  /// Replaces `images` by all that are within `reach` (m) of the part along both axes; with a reach of 0
  /// those with low <= coordinate < high: exactly m where the part is m periods long, whatever rounding does.
  /// Along an axis that is not periodic there is the place itself only, wherever it lies. Throws (bad input):
  /// more than 10,000.
  void of(const Eigen::Vector2d& place, double reach, std::vector<Eigen::Vector2d>& images) const {
    images.clear();
    if (any_) {
      add(place, reach, images);
    } else {
      images.push_back(place);
    }
  }

 private:
  // From first + begin period to before first + end period.
  struct Row {
    double first;
    double begin;
    double end;
  };
  struct Axis {
    double low;
    double high;
    double period;  // 0: not periodic
    double whole;   // periods from low to high; 0: no whole number of them

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
