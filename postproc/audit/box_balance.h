// What walls do to the discs between them, beside what goes on inside: balances of a box.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "io/frame.h"

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
/// Throws (bad input) where a wall has no contact in the frame, or where the walls stand in no such order.
Rectangle wall_rectangle(const Frame& frame);

/// Sums over the contacts of one frame.
struct BoxLoad {
  std::array<Eigen::Vector2d, box_walls> force;  ///< of each wall on the discs, N
  /// sum f (x) (x_c - m), N m: f on the averaged discs, of walls of any id and of discs that are not averaged
  /// (wall discs); x_c the contact point, in the middle of the overlap or, at walls, on the wall; m the
  /// middle of the rectangle.
  Eigen::Matrix2d moment;
  double normal = 0;      ///< sum of |f_n| of the four walls, N
  double tangential = 0;  ///< and of |f_t|
};

BoxLoad box_load(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// sum pi a^2 (m^2) of the averaged discs with their centres in the rectangle, low edges included.
double disc_area_inside(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types);

/// The stress that one wall exerts, force per area of wall: the column of sigma that belongs to its normal.
struct WallStress {
  Eigen::Vector2d force;   ///< of the wall on the discs, N
  double area = 0;         ///< m^2
  Eigen::Vector2d stress;  ///< (sigma_xx, sigma_yx) for left and right, (sigma_xy, sigma_yy) for bottom and
                           ///< top, Pa; compression is negative
};

/// Balance of a box that rests, from means over frames (docs/conventions.md).
class BoxBalance {
 public:
  /// Adds a frame: V sigma (N m) is the sum of f (x) l over the averaged discs with their centres in the
  /// rectangle, with branches to the contact points.
  void add(const Rectangle& box, double height, const Eigen::Matrix2d& volume_times_stress,
           const BoxLoad& load);

  std::int64_t frames() const { return frames_; }
  /// Means over the frames, m.
  Rectangle box() const;
  /// 1/V sum f (x) l, Pa.
  Eigen::Matrix2d volume_stress() const { return inside_ / volume_; }
  /// 1/V sum f (x) (x_c - m) over the boundary, Pa: the same in equilibrium, whatever the walls are like.
  Eigen::Matrix2d boundary_stress() const { return boundary_ / volume_; }
  WallStress wall(int number) const;

  /// Largest difference of the components of both, over the pressure -tr sigma/2 of the volume.
  double stress_deviation() const;
  /// Largest difference of the normal stress of a wall and of the volume, over the pressure: 0 in equilibrium
  /// where no wall has tangential forces. Those of its neighbours would carry a part of the load.
  double wall_deviation() const;
  /// |sum of the forces of all four walls| over the mean of their magnitudes.
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
};

}  // namespace mikromakro
