// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/needed_columns.h"

namespace mikromakro {
namespace {

using enum ContactColumn;

constexpr ColumnSet derivable_columns = column_set(nx, ny, overlap);
constexpr ColumnSet place_columns = column_set(x1, y1, x2, y2);
constexpr ColumnSet spring_columns = column_set(xi, shearx, sheary);
constexpr ColumnSet across_columns = column_set(z1, z2, fz, shearz, ftz);
constexpr ColumnSet tangential_columns = column_set(ftx, fty);
constexpr ColumnSet wall_name_columns = column_set(mesh);

bool contains(ColumnSet set, ColumnSet columns) {
  return (columns & ~set) == 0;
}

}  // namespace

ColumnSet required_contact_columns(ColumnSet needed, ColumnSet given) {
  const ColumnSet force = contains(given, column_set(fn, ft)) ? column_set(fx, fy) : 0;
  return (needed & ~derivable_columns & ~force) | column_set(id1, id2);
}

ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given, bool closely) {
  if (needed == 0) return given;
  const ColumnSet derive_from = (derivable_columns & ~given) != 0 ? place_columns : 0;
  const ColumnSet force =
      contains(given, column_set(fx, fy)) ? column_set(fx, fy) | tangential_columns : column_set(fn, ft);
  const ColumnSet to_check = closely ? place_columns | column_set(fn, ft) : 0;
  // Fields use springs if present, without requiring them; forces distinguish contacts from neighbour pairs.
  return given & (needed | to_check | derivable_columns | derive_from | force | spring_columns |
                  across_columns | wall_name_columns | column_set(id1, id2, dist, periodic));
}

}  // namespace mikromakro
