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

/// Throws unless the z of all particles (added one by one) are equal within 1e-6 of a radius: averages are
/// two-dimensional, and spheres above each other would count as overlapping discs.
class PlaneCheck {
 public:
  void add(double z, double radius, const Place& place);

 private:
  double plane_ = not_given;
};

/// The particles of one frame, or of a piece of it.
struct ParticleRows {
  std::vector<Particle> particles;
  ColumnSet given = 0;             ///< the available columns
  double place_error = not_given;  ///< see ParticleColumns
};

/// Converts the rows of a frame to particles (units as in the file). `list`: the names of --particle-columns
/// (empty: the header's own), which must include `needed`. Without an id column, ids are the row numbers from
/// 1. Throws on missing columns, and on everything that ParticleColumns, particle_of and PlaneCheck throw on.
ParticleRows read_particles(const RowBlock& block, const std::vector<std::string>& list, ColumnSet needed);

}  // namespace mikromakro
