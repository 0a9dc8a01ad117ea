// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/wall_numbers.h"

namespace mikromakro {
namespace {

constexpr WallQuantity of_cell[] = {{"torque_inner", "N m", "torque of the discs on the wheel"},
                                    {"torque_outer", "N m", "torque of the discs on the outer ring"},
                                    {"pressure_inner", "Pa", "pressure on the wheel"},
                                    {"pressure_outer", "Pa", "pressure on the outer ring"},
                                    {"angle_inner", "rad", "angle of the wheel"},
                                    {"angle_outer", "rad", "angle of the outer ring"},
                                    {"r_outer", "m", "outer radius"},
                                    {"r_outer_rate", "m/s", "rate of the outer radius"},
                                    {"power_inner", "W", "power of the wheel"}};

constexpr WallQuantity of_box[] = {{"x_left", "m", "position of the left wall"},
                                   {"x_right", "m", "position of the right wall"},
                                   {"y_bottom", "m", "position of the bottom wall"},
                                   {"y_top", "m", "position of the top wall"},
                                   {"v_left", "m/s", "velocity of the left wall"},
                                   {"v_right", "m/s", "velocity of the right wall"},
                                   {"v_bottom", "m/s", "velocity of the bottom wall"},
                                   {"v_top", "m/s", "velocity of the top wall"},
                                   {"force_left", "N", "force that pushes the left wall outwards"},
                                   {"force_right", "N", "force that pushes the right wall outwards"},
                                   {"force_bottom", "N", "force that pushes the bottom wall outwards"},
                                   {"force_top", "N", "force that pushes the top wall outwards"},
                                   {"pressure_left", "Pa", "pressure on the left wall"},
                                   {"pressure_right", "Pa", "pressure on the right wall"},
                                   {"pressure_bottom", "Pa", "pressure on the bottom wall"},
                                   {"pressure_top", "Pa", "pressure on the top wall"},
                                   {"strain_x", "1", "horizontal strain of the box"},
                                   {"strain_y", "1", "vertical strain of the box"},
                                   {"strain_area", "1", "areal strain of the box"},
                                   {"work_left", "J", "work of the left wall on the discs"},
                                   {"work_right", "J", "work of the right wall on the discs"},
                                   {"work_bottom", "J", "work of the bottom wall on the discs"},
                                   {"work_top", "J", "work of the top wall on the discs"},
                                   {"shear_left", "N", "force along the left wall"},
                                   {"shear_right", "N", "force along the right wall"},
                                   {"shear_bottom", "N", "force along the bottom wall"},
                                   {"shear_top", "N", "force along the top wall"}};

constexpr WallQuantity of_wall[] = {{"force_x", "N", "force of the discs on the wall along x"},
                                    {"force_y", "N", "force of the discs on the wall along y"},
                                    {"torque", "N m", "torque of the discs on the wall"},
                                    {"work", "J", "work of the wall on the discs"},
                                    {"force_normal", "N", "sum of the normal forces"}};

}  // namespace

std::span<const WallQuantity> wall_quantities(std::string_view style) {
  if (style == "couette/2d") return of_cell;
  if (style == "biaxial/2d") return of_box;
  if (style == "wall/disc") return of_wall;
  return {};
}

}  // namespace mikromakro
