// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of one particle in a file, and the particle that they make.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "model/columns.h"
#include "model/frame.h"
#include "model/whole_number.h"

namespace mikromakro {

/// Behind the numbers of ParticleColumn a row has room for z, which must be the same for all.
inline constexpr std::size_t particle_z = static_cast<std::size_t>(ParticleColumn::count);
using ParticleSlots = std::array<double, particle_z + 1>;

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

}  // namespace mikromakro
