// SPDX-License-Identifier: GPL-2.0-or-later
// The volumes of a table as polygons.
#pragma once

#include "io/tables/vtkhdf.h"

namespace mikromakro {

/// Rings (columns r_inner, r_outer) and sectors (phi_begin, phi_end, too) as polygons of 2 degrees or less
/// around `center`, so that they look round; rectangles (x_min, x_max, y_min, y_max) as they are. Rows
/// without numbers there give none.
std::vector<Outline> volume_outlines(const Table& table, const Eigen::Vector2d& center);

}  // namespace mikromakro
