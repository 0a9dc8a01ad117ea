// SPDX-License-Identifier: GPL-2.0-or-later
// Discs and contacts of MercuryDPM's rows.
#pragma once

#include <vector>

#include "io/mercury/mercury_reader.h"
#include "io/text/contact_reader.h"

namespace mikromakro {

/// What .data and .fstat tell.
inline constexpr ColumnSet mercury_particle_columns =
    column_set(ParticleColumn::id, ParticleColumn::type, ParticleColumn::x, ParticleColumn::y,
               ParticleColumn::radius, ParticleColumn::vx, ParticleColumn::vy, ParticleColumn::omegaz);
inline constexpr ColumnSet mercury_contact_columns = column_set(
    ContactColumn::id1, ContactColumn::id2, ContactColumn::nx, ContactColumn::ny, ContactColumn::overlap,
    ContactColumn::fx, ContactColumn::fy, ContactColumn::fn, ContactColumn::ft, ContactColumn::xi);

/// Walls keep numbers of their own below ours: wall -1 of the file gets -101, and so on.
inline constexpr std::int64_t mercury_walls = -100;

/// Rows `x y vx vy r phi -omega species` or `x y z vx vy vz r phi_x phi_y phi_z omega_x omega_y omega_z
/// species`: the plane is x-y, all z must be the same. The id is the number of the row from 1 (the files
/// count from 0), the type is the species + 1. In the rows of 8 columns the sign of omega is turned:
/// MercuryDPM reads it back so. The last column is free there, the species only by default: where it holds
/// other numbers there are no types, and `given` says so. Throws: another number of columns, numbers that are
/// none, no species where `needed` has the type, centres that are not in a plane, and what particle_of
/// throws.
std::vector<Particle> mercury_particles(const MercuryBlock& block, ColumnSet needed, ColumnSet& given);

/// Rows `time i j x y z overlap xi f_n f_t n_x n_y n_z t_x t_y t_z`. The force on i is f_n n + f_t t with n
/// from j to i; where j < 0 is a wall, both point the other way (MercuryDPM says so in its source). A pair of
/// free particles has two rows, one for each of them, one that holds a fixed particle has one: the second row
/// is dropped. xi is a length there; its sign follows from f_t, as far as that is elastic. Throws: wrong
/// numbers, an index without a particle (copies across periodic boundaries have such), a normal that does not
/// point from j to i, two rows of a pair that differ.
ContactRows mercury_contacts(const MercuryBlock& block, const std::vector<Particle>& particles);

}  // namespace mikromakro
