// SPDX-License-Identifier: GPL-2.0-or-later
// Particles of one dump frame.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/files/column_map.h"
#include "io/files/row_parser.h"
#include "io/text/dump_reader.h"
#include "io/text/particle_columns.h"
#include "model/frame.h"

namespace mikromakro {

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
