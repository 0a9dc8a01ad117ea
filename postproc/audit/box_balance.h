// SPDX-License-Identifier: GPL-2.0-or-later
// What walls do to the discs between them, beside what goes on inside: balances of a box.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// A rectangle along x and y (m).
struct Rectangle {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  Eigen::Vector2d size() const { return high - low; }
};

/// Left, right, bottom, top: contacts with id2 = -1, -2, -3, -4.
inline constexpr int box_walls = 4;

/// The rectangle between the four walls: each lies where its contacts are, at the mean of the contact points.
/// Where the frame's box is periodic and neither of the two walls has a contact: from one end of the box to
/// the other. Throws (bad input) where a wall has no contact in the frame else, or where the walls stand in
/// no such order.
Rectangle wall_rectangle(const Frame& frame);

/// Sums over the contacts of one frame.
struct BoxLoad {
  std::array<Eigen::Vector2d, box_walls> force;  ///< of each wall on the discs, N
  /// sum f (x) (x_c - m), N m: f on the averaged discs, of walls of any id and of discs that are not averaged
  /// (wall discs); x_c the contact point, in the middle of the overlap or, at walls, on the wall; m the
  /// middle of the rectangle.
  Eigen::Matrix2d moment;
  double normal = 0;                   ///< sum of |f_n| of the four walls, N
  double tangential = 0;               ///< and of |f_t|
  std::int64_t boundary_contacts = 0;  ///< with walls of any id, and with discs that are not averaged
  std::array<std::int64_t, 2> wall_contacts = {};  ///< with left or right, with bottom or top
  std::array<std::int64_t, 2> crossings = {};  ///< of averaged discs through the periodic boundary along x, y
  std::array<bool, 2> periodic = {};
};

/// Throws (bad input) where the rectangle is not as long as the period along an axis that forces cross beside
/// one that they do not.
BoxLoad box_load(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// sum pi a^2 (m^2) of the averaged discs with their centres, or those of periodic images, in the rectangle,
/// low edges included.
double disc_area_inside(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// The stress that one wall exerts, force per area of wall: the column of sigma that belongs to its normal.
struct WallStress {
  Eigen::Vector2d force;   ///< of the wall on the discs, N
  double area = 0;         ///< m^2
  Eigen::Vector2d stress;  ///< (sigma_xx, sigma_yx) for left and right, (sigma_xy, sigma_yy) for bottom and
                           ///< top, Pa; compression is negative
};

/// Balance of a box that rests, from means over frames (docs/conventions.md). Where forces pass through a
/// periodic boundary, the column of sigma that belongs to its normal has no boundary to be compared with;
/// what is said below is about the other one.
class BoxBalance {
 public:
  /// Adds a frame: V sigma (N m) is the sum of f (x) l over the averaged discs with their centres in the
  /// rectangle, with branches to the contact points. Throws (bad input) when the boundaries of the box are
  /// not those of the frames before.
  void add(const Rectangle& box, double height, const Eigen::Matrix2d& volume_times_stress,
           const BoxLoad& load);

  std::int64_t frames() const { return frames_; }
  /// Means over the frames, m.
  Rectangle box() const;
  /// 1/V sum f (x) l, Pa.
  Eigen::Matrix2d volume_stress() const { return inside_ / volume_; }
  /// 1/V sum f (x) (x_c - m) over the boundary, Pa: the same in equilibrium, whatever the walls are like. nan
  /// in columns that have no boundary.
  Eigen::Matrix2d boundary_stress() const;
  /// Whether the column of sigma of this normal has no boundary: forces cross a periodic one, or it is
  /// periodic and there is no other.
  bool is_open(int axis) const;
  /// Whether there are contacts with a boundary, and with one of the four walls.
  bool has_boundary() const { return boundary_contacts_ > 0; }
  bool has_walls() const { return wall_contacts_[0] + wall_contacts_[1] > 0; }
  /// Whether this one of the four can be there.
  bool may_have_wall(int number) const;
  WallStress wall(int number) const;

  /// Largest difference of the components of both, over the pressure -tr sigma/2 of the volume.
  double stress_deviation() const;
  /// Largest difference of the normal stress of a wall and of the volume, over the pressure: 0 in equilibrium
  /// where no wall has tangential forces. Those of its neighbours would carry a part of the load.
  double wall_deviation() const;
  /// |sum of the forces of all walls| over the mean of their magnitudes.
  double wall_residual() const;
  /// sum |f_t|/sum |f_n| of the contacts with walls.
  double friction() const { return tangential_ / normal_; }

 private:
  double pressure() const;

  std::int64_t frames_ = 0;
  double volume_ = 0;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d inside_ = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d boundary_ = Eigen::Matrix2d::Zero();
  std::array<Eigen::Vector2d, box_walls> force_ = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                                   Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  Eigen::Vector2d wall_areas_ = Eigen::Vector2d::Zero();  // of left or right, of bottom or top
  double normal_ = 0;
  double tangential_ = 0;
  std::int64_t boundary_contacts_ = 0;
  std::array<std::int64_t, 2> wall_contacts_ = {};
  std::array<std::int64_t, 2> crossings_ = {};
  std::array<bool, 2> periodic_ = {};
};

}  // namespace mikromakro
