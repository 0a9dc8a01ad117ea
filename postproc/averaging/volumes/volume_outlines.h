// SPDX-License-Identifier: GPL-2.0-or-later
// The volumes of a table as polygons.
#pragma once

#include "io/tables/vtkhdf.h"

namespace mikromakro {

/// Rings (columns r_inner, r_outer) and sectors (also phi_begin, phi_end) as polygons of at most 2 degrees
/// per side around `center`, so that they look round; rectangles (x_min, x_max, y_min, y_max) as they are.
/// Rows with undefined coordinates have no outline.
std::vector<Outline> volume_outlines(const Table& table, const Eigen::Vector2d& center);

}  // namespace mikromakro
