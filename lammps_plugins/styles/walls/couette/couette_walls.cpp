// SPDX-License-Identifier: GPL-2.0-or-later
// fix couette/2d: smooth rings, as circular walls.
#include "walls/couette/fix_couette_2d.h"

namespace mikromakro::styles {
namespace {

// Ids of the inner and the outer ring in contact rows.
constexpr std::array<int, 2> wall_ids = {0, -5};

}  // namespace

void FixCouette2d::add_smooth_rings() {
  const std::array<std::string, 2> names = {"inner smooth", "outer smooth"};
  const auto& rings = settings_.rings;
  for (std::size_t side = 0; side < rings.size(); ++side) {
    if (rings[side].smooth()) walls_.add(wall_ids[side], names[side], rings[side].type);
  }
  walls_.act_on(groupbit, rings[0].group_bit | rings[1].group_bit);
}

std::vector<physics::SmoothWall> FixCouette2d::smooth_rings_at(LAMMPS_NS::bigint step) const {
  std::vector<physics::SmoothWall> walls;
  const Rings rings = rings_at(step);
  for (std::size_t side = 0; side < rings.size(); ++side) {
    if (!settings_.rings[side].smooth()) continue;
    physics::SmoothWall& wall = walls.emplace_back();
    wall.shape = side == 0 ? physics::WallShape::circle_within : physics::WallShape::circle_around;
    wall.point = settings_.centre;
    wall.radius = rings[side].radius;
    wall.rotation_rate = rings[side].rotation_rate;
    wall.radial_velocity = rings[side].radial_velocity;
  }
  return walls;
}

void FixCouette2d::add_loads_of_smooth_rings() {
  std::size_t number = 0;
  for (std::size_t side = 0; side < loads_.size(); ++side) {
    if (!settings_.rings[side].smooth()) continue;
    const physics::WallLoad& load = walls_.loads()[number++];
    loads_[side].torque += load.torque;
    loads_[side].outward_force += side == 0 ? 0.0 - load.pressing : load.pressing;
  }
}

}  // namespace mikromakro::styles
