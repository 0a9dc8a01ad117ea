// SPDX-License-Identifier: GPL-2.0-or-later
// A frame as its rows stand in the files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/units.h"

namespace mikromakro {

/// What a run tells about its walls in one step: the numbers of a fix, under the fix's name.
struct WallState {
  std::string name;
  std::string style;  ///< tells what the numbers are
  std::vector<double> numbers;
};

/// A frame before its contacts are joined to its particles. For messages: particle i stands in line
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
  double place_error = not_given;  ///< what coordinates of discs have lost (m); nan: as their digits say
  double time = not_given;         ///< s
  Units units = {};                ///< in which all of it stands until it is joined
  bool closely = false;            ///< contacts that are missing are looked for, too
  std::vector<WallState> walls;

  Place place_of_particle(std::size_t i) const {
    return place_of_row(i, {particle_file, first_particle_line + static_cast<std::int64_t>(i)},
                        further_pieces);
  }
};

}  // namespace mikromakro
