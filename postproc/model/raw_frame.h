// SPDX-License-Identifier: GPL-2.0-or-later
// A frame as read from the files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/units.h"

namespace mikromakro {

/// A frame before its contacts are joined to its particles. For messages: particle i is in line
/// first_particle_line + i of particle_file, or in a further piece.
struct RawFrame {
  std::int64_t step = 0;
  Box box;
  std::vector<Particle> particles;
  ColumnSet particles_given = 0;
  std::string particle_file;
  std::int64_t first_particle_line = 0;
  std::vector<FurtherPiece> further_pieces = {};
  bool with_contacts = false;
  ContactRows contacts;
  double place_error = not_given;  ///< rounding error of coordinates (m); nan: inferred from their digits
  double time = not_given;         ///< s
  Units units = {};                ///< units of all members until the frame is joined
  bool closely = false;            ///< also check for missing contacts
  std::vector<WallState> walls;

  Place place_of_particle(std::size_t i) const {
    return place_of_row(i, {particle_file, first_particle_line + static_cast<std::int64_t>(i)},
                        further_pieces);
  }
};

}  // namespace mikromakro
