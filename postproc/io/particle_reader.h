// Particles of one dump frame.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/dump_reader.h"
#include "io/frame.h"

namespace mikromakro {

/// What every average needs of a particle.
inline constexpr ColumnSet particle_base_columns =
    column_set(ParticleColumn::id, ParticleColumn::x, ParticleColumn::y, ParticleColumn::radius);

/// Numbers of a row, by ParticleColumn.
using ParticleSlots = std::array<double, static_cast<std::size_t>(ParticleColumn::count)>;

/// A particle from its numbers, nan where `given` has no such column. Throws: radius or mass <= 0, ids below
/// 1 or not whole, types below 1 where they are given.
Particle particle_of(const ParticleSlots& slots, ColumnSet given, const Place& place);

/// Turns the rows of a frame into particles (SI units as in the file).
/// `list` are the names of --particle-columns (empty: the header's own); `needed` must be among them.
/// Throws: missing columns, and all that particle_of throws. `given` becomes the columns that are there.
std::vector<Particle> read_particles(const RowBlock& block, const std::vector<std::string>& list,
                                     ColumnSet needed, ColumnSet& given);

}  // namespace mikromakro
