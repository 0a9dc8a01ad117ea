// SPDX-License-Identifier: GPL-2.0-or-later
// Balances of a box: forces of the walls on the discs against the stress inside.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// An axis-aligned rectangle (m).
struct Rectangle {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  Eigen::Vector2d size() const { return high - low; }
};

/// Left, right, bottom, top: contacts with id2 = -1, -2, -3, -4.
inline constexpr int box_walls = 4;

/// The rectangle between the four walls, each at the mean of its contact points. Along a periodic axis
/// without contacts on either wall, it spans the box. Throws (bad input) if any other wall has no contact in
/// the frame, or if the walls are not in this order.
Rectangle wall_rectangle(const Frame& frame);

/// Sums over the contacts of one frame.
struct BoxLoad {
  std::array<Eigen::Vector2d, box_walls> force;  ///< of each wall on the discs, N
  /// sum f (x) (x_c - m), N m: f acts on the averaged discs and comes from walls of any id and from discs
  /// that are not averaged (wall discs); x_c is the contact point, in the middle of the overlap or, at walls,
  /// on the wall; m is the centre of the rectangle.
  Eigen::Matrix2d moment;
  double normal = 0;                   ///< sum of |f_n| over the four walls, N
  double tangential = 0;               ///< the same for |f_t|
  std::int64_t boundary_contacts = 0;  ///< with walls of any id, and with discs that are not averaged
  std::array<std::int64_t, 2> wall_contacts = {};  ///< with left or right, with bottom or top
  std::array<std::int64_t, 2> crossings = {};      ///< averaged discs, across the boundary along x, y
  std::array<bool, 2> periodic = {};
  bool cut = false;  ///< averaged discs lie outside of the rectangle, or it does not end at the walls
};

/// Throws (bad input) if contact forces cross a periodic boundary along one axis only and the rectangle does
/// not span the period along that axis.
BoxLoad box_load(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// sum pi a^2 (m^2) of the averaged discs whose centres, or those of their periodic images, lie in the
/// rectangle, lower edges included.
double disc_area_inside(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// Stress exerted by one wall, force per wall area: the column of sigma for the wall normal.
struct WallStress {
  Eigen::Vector2d force;   ///< of the wall on the discs, N
  double area = 0;         ///< m^2
  Eigen::Vector2d stress;  ///< (sigma_xx, sigma_yx) for left and right, (sigma_xy, sigma_yy) for bottom and
                           ///< top, Pa; compression is negative
};

/// Balance of a box at rest, from means over frames (docs/conventions.md). If forces cross a periodic
/// boundary, the column of sigma for its normal has no boundary to be compared with; the statements below
/// then refer to the other column.
class BoxBalance {
 public:
  /// Adds a frame: V sigma (N m) is the sum of f (x) l over the averaged discs with their centres in the
  /// rectangle, with branch vectors to the contact points. Throws (bad input) if the boundary types of the
  /// box differ from those of earlier frames.
  void add(const Rectangle& box, double height, const Eigen::Matrix2d& volume_times_stress,
           const BoxLoad& load);

  std::int64_t frames() const { return frames_; }
  /// Mean over the frames, m.
  Rectangle box() const;
  /// 1/V sum f (x) l, Pa.
  Eigen::Matrix2d volume_stress() const { return inside_ / volume_; }
  /// 1/V sum f (x) (x_c - m) over the boundary, Pa: equal to volume_stress() in equilibrium, for any kind of
  /// walls. nan in columns that have no boundary.
  Eigen::Matrix2d boundary_stress() const;
  /// Whether the column of sigma for this normal has no boundary: forces cross a periodic boundary, or the
  /// axis is periodic and there is no other boundary, or the rectangle is cut.
  bool is_open(int axis) const;
  /// Whether the rectangle is a part of the box in some frame, so that forces cross its edges.
  bool is_cut() const { return cut_; }
  /// Whether there are contacts with any boundary, and with one of the four walls, of a rectangle that is not
  /// cut.
  bool has_boundary() const { return boundary_contacts_ > 0 && !cut_; }
  bool has_walls() const { return wall_contacts_[0] + wall_contacts_[1] > 0 && !cut_; }
  /// Whether this wall (of the four) can exist.
  bool may_have_wall(int number) const;
  WallStress wall(int number) const;

  /// Largest difference between the components of the two stresses, relative to the pressure -tr sigma/2 of
  /// the volume.
  double stress_deviation() const;
  /// Largest difference between the normal stress of a wall and that of the volume, relative to the pressure:
  /// 0 in equilibrium if no wall has tangential forces. Tangential forces of the adjacent walls would carry
  /// part of the load.
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
  bool cut_ = false;
};

}  // namespace mikromakro
