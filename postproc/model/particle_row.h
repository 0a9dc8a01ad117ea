// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of one particle in a file, and the particle made from them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "model/columns.h"
#include "model/frame.h"
#include "model/whole_number.h"

namespace mikromakro {

/// After the numbers of ParticleColumn, a row has a slot for z, which must be equal for all particles.
inline constexpr std::size_t particle_z = static_cast<std::size_t>(ParticleColumn::count);
using ParticleSlots = std::array<double, particle_z + 1>;

/// Columns that every average needs; contacts also need the id.
inline constexpr ColumnSet particle_base_columns =
    column_set(ParticleColumn::x, ParticleColumn::y, ParticleColumn::radius);

/// An integer of a row, 0 if `given` has no such column.
inline std::int64_t given_or_0(const ParticleSlots& slots, ColumnSet given, ParticleColumn column) {
  return (given & column_bit(column)) != 0
             ? static_cast<std::int64_t>(slots[static_cast<std::size_t>(column)])
             : 0;
}

/// Throws whatever particle_of() throws.
void check_particle(const ParticleSlots& slots, ColumnSet given, const Place& place);

/// True if check_particle() would not throw.
inline bool is_sound(const ParticleSlots& slots, ColumnSet given) {
  const auto lacks = [&](ParticleColumn column) { return (given & column_bit(column)) == 0; };
  const auto at = [&](ParticleColumn column) { return slots[static_cast<std::size_t>(column)]; };
  const auto counts = [&](ParticleColumn column) { return at(column) >= 1 && is_integer(at(column)); };
  return (lacks(ParticleColumn::id) || counts(ParticleColumn::id)) &&
         (lacks(ParticleColumn::type) ||
          (counts(ParticleColumn::type) && at(ParticleColumn::type) <= std::numeric_limits<int>::max())) &&
         at(ParticleColumn::radius) > 0 && (lacks(ParticleColumn::mass) || at(ParticleColumn::mass) > 0);
}

/// Makes a particle from its numbers; columns not in `given` are nan (id and type: 0). Throws on radius or
/// mass <= 0, and on given ids and types that are below 1 or not integers.
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

}  // namespace mikromakro
