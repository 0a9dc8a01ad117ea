// SPDX-License-Identifier: GPL-2.0-or-later
// Particles of one dump frame.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/dump_reader.h"
#include "io/frame.h"
#include "io/particle_columns.h"
#include "io/row_parser.h"

namespace mikromakro {

/// What every average needs of a particle; contacts need its id, too.
inline constexpr ColumnSet particle_base_columns =
    column_set(ParticleColumn::x, ParticleColumn::y, ParticleColumn::radius);

/// A whole number of a row, 0 where `given` has no such column.
inline std::int64_t given_or_0(const ParticleSlots& slots, ColumnSet given, ParticleColumn column) {
  return (given & column_bit(column)) != 0
             ? static_cast<std::int64_t>(slots[static_cast<std::size_t>(column)])
             : 0;
}

/// Throws what particle_of does.
void check_particle(const ParticleSlots& slots, ColumnSet given, const Place& place);

/// Whether it would throw nothing.
inline bool is_sound(const ParticleSlots& slots, ColumnSet given) {
  const auto lacks = [&](ParticleColumn column) { return (given & column_bit(column)) == 0; };
  const auto at = [&](ParticleColumn column) { return slots[static_cast<std::size_t>(column)]; };
  const auto counts = [&](ParticleColumn column) { return at(column) >= 1 && is_integer(at(column)); };
  return (lacks(ParticleColumn::id) || counts(ParticleColumn::id)) &&
         (lacks(ParticleColumn::type) ||
          (counts(ParticleColumn::type) && at(ParticleColumn::type) <= std::numeric_limits<int>::max())) &&
         at(ParticleColumn::radius) > 0 && (lacks(ParticleColumn::mass) || at(ParticleColumn::mass) > 0);
}

/// A particle from its numbers, nan where `given` has no such column (id and type 0). Throws: radius or mass
/// <= 0, ids and types below 1 or not whole where they are given.
inline Particle particle_of(const ParticleSlots& slots, ColumnSet given, const Place& place) {
  const auto at = [&](ParticleColumn column) { return slots[static_cast<std::size_t>(column)]; };
  if (!is_sound(slots, given)) check_particle(slots, given, place);
  return {given_or_0(slots, given, ParticleColumn::id),
          static_cast<int>(given_or_0(slots, given, ParticleColumn::type)),
          {at(ParticleColumn::x), at(ParticleColumn::y)},
          at(ParticleColumn::radius),
          {at(ParticleColumn::vx), at(ParticleColumn::vy)},
          at(ParticleColumn::omegaz),
          at(ParticleColumn::mass)};
}

/// Throws where the z of particles (one after the other) is not the same within 1e-6 of a radius: averages
/// are of the plane, and spheres above each other would count as overlapping discs.
class PlaneCheck {
 public:
  void add(double z, double radius, const Place& place);

 private:
  double plane_ = not_given;
};

/// Of one frame, or a piece of it.
struct ParticleRows {
  std::vector<Particle> particles;
  ColumnSet given = 0;             ///< the columns that are there
  double place_error = not_given;  ///< see ParticleColumns
};

/// Turns the rows of a frame into particles (units as in the file).
/// `list` are the names of --particle-columns (empty: the header's own); `needed` must be among them.
/// Without a column of ids they are the numbers of the rows, from 1. Throws: missing columns, and all that
/// ParticleColumns, particle_of and PlaneCheck throw.
ParticleRows read_particles(const RowBlock& block, const std::vector<std::string>& list, ColumnSet needed);

}  // namespace mikromakro
