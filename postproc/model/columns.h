// SPDX-License-Identifier: GPL-2.0-or-later
// The particle and contact quantities that dumps contain, and sets of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace mikromakro {

/// Quantities of a particle row, named as in LAMMPS and LIGGGHTS.
enum class ParticleColumn { id, type, x, y, radius, vx, vy, omegaz, mass, count };
inline constexpr std::string_view particle_column_names[] = {"id", "type", "x",      "y",   "radius",
                                                             "vx", "vy",   "omegaz", "mass"};

/// Quantities of a contact row: the columns of `compute contact/disc`, then the periodic flag and the two
/// spring components of stock LIGGGHTS and the distance of stock LAMMPS. Enumerators from `count` on are only
/// checked while a row is read, and not stored.
enum class ContactColumn {
  id1,
  id2,
  x1,
  y1,
  x2,
  y2,
  nx,
  ny,
  overlap,
  fx,
  fy,
  fn,
  ft,
  xi,
  vn,
  vt,
  periodic,
  dist,
  shearx,
  sheary,
  count,
  z1 = count,
  z2,
  fz,
  shearz,
  ftx,
  fty,
  ftz,
  mesh,
  read_count
};
inline constexpr std::string_view contact_column_names[] = {
    "id1", "id2", "x1", "y1", "x2", "y2", "nx",       "ny",   "overlap", "fx",
    "fy",  "fn",  "ft", "xi", "vn", "vt", "periodic", "dist", "shearx",  "sheary"};
/// The same, including those that are not stored.
inline constexpr std::string_view contact_read_names[] = {
    "id1", "id2", "x1", "y1",     "x2",  "y2",  "nx",       "ny",   "overlap", "fx",
    "fy",  "fn",  "ft", "xi",     "vn",  "vt",  "periodic", "dist", "shearx",  "sheary",
    "z1",  "z2",  "fz", "shearz", "ftx", "fty", "ftz",      "mesh"};
/// Number of columns of `compute contact/disc`, the first in the list above.
inline constexpr int contact_disc_columns = 16;

/// A set of columns, one bit per enumerator.
using ColumnSet = std::uint32_t;
template <typename Column>
constexpr ColumnSet column_bit(Column column) {
  return ColumnSet{1} << static_cast<unsigned>(column);
}
template <typename... Columns>
constexpr ColumnSet column_set(Columns... columns) {
  return (column_bit(columns) | ...);
}

static_assert(std::size(particle_column_names) == static_cast<std::size_t>(ParticleColumn::count));
static_assert(std::size(contact_column_names) == static_cast<std::size_t>(ContactColumn::count));
static_assert(std::size(contact_read_names) == static_cast<std::size_t>(ContactColumn::read_count));
static_assert(std::equal(std::begin(contact_column_names), std::end(contact_column_names),
                         std::begin(contact_read_names)));

}  // namespace mikromakro
