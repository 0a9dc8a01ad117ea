// SPDX-License-Identifier: GPL-2.0-or-later
// Discs and contacts from MercuryDPM rows.
#pragma once

#include <vector>

#include "io/mercury/mercury_reader.h"
#include "io/text/contact_reader.h"

namespace mikromakro {

/// Columns that .data and .fstat provide.
inline constexpr ColumnSet mercury_particle_columns =
    column_set(ParticleColumn::id, ParticleColumn::type, ParticleColumn::x, ParticleColumn::y,
               ParticleColumn::radius, ParticleColumn::vx, ParticleColumn::vy, ParticleColumn::omegaz);
inline constexpr ColumnSet mercury_contact_columns = column_set(
    ContactColumn::id1, ContactColumn::id2, ContactColumn::nx, ContactColumn::ny, ContactColumn::overlap,
    ContactColumn::fx, ContactColumn::fy, ContactColumn::fn, ContactColumn::ft, ContactColumn::xi);

/// MercuryDPM walls get ids below ours: wall -1 of the file becomes -101, and so on.
inline constexpr std::int64_t mercury_walls = -100;

/// Rows `x y vx vy r phi -omega species` or `x y z vx vy vz r phi_x phi_y phi_z omega_x omega_y omega_z
/// species`: the plane is x-y, all z must be equal. The id is the row number from 1 (the files count from 0),
/// the type is species + 1. In rows of 8 columns the sign of omega is reversed, as MercuryDPM does on
/// reading. The last column of these is user-defined and only by default the species: if it holds other
/// numbers there are no types, and `given` says so. Throws on a wrong number of columns, malformed numbers, a
/// missing species if `needed` includes the type, centres that are not in a plane, and on everything that
/// particle_of throws on.
std::vector<Particle> mercury_particles(const MercuryBlock& block, ColumnSet needed, ColumnSet& given);

/// Rows `time i j x y z overlap xi f_n f_t n_x n_y n_z t_x t_y t_z`. The force on i is f_n n + f_t t, with n
/// from j to i; if j < 0 it is a wall, and both point the other way (as stated in the MercuryDPM source). A
/// pair of free particles has two rows, one per particle, and a pair with a fixed particle has one: the
/// second row is dropped. xi is given as a length; its sign follows from f_t, as far as f_t is elastic.
/// Throws on malformed numbers, an index without a particle (as for copies across periodic boundaries), a
/// normal that does not point from j to i, and two rows of a pair that differ.
ContactRows mercury_contacts(const MercuryBlock& block, const std::vector<Particle>& particles);

}  // namespace mikromakro
