// SPDX-License-Identifier: GPL-2.0-or-later
// What every kind of input gives: frames one after the other, as their rows stand in the file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/column_map.h"
#include "io/contact_reader.h"
#include "io/frame.h"
#include "io/units.h"

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

/// Makes a frame of bytes that were taken out of the files before; reads no file and shares nothing that
/// changes, so that several threads may do it for several frames.
using UnpackFrame = std::function<void(RawFrame&)>;

/// One of the formats: text dumps, HDF5 snapshots, MercuryDPM files.
class FrameFormat {
 public:
  FrameFormat() = default;
  FrameFormat(const FrameFormat&) = delete;
  FrameFormat& operator=(const FrameFormat&) = delete;
  virtual ~FrameFormat() = default;

  /// Goes to the next frame; false at the end.
  virtual bool next(std::int64_t& step) = 0;
  /// Takes the bytes of the frame that `next` has found; may be left out to skip it. `closely`: with all
  /// columns of contacts that can be checked, whether they are needed or not.
  virtual UnpackFrame take(bool closely = false) = 0;
  /// The run of that frame, from 0.
  virtual std::int64_t run() const { return 0; }
  /// How many rows of contacts it has, all files together; -1 where only its rows tell.
  virtual std::int64_t contact_rows() const { return -1; }
  /// For the progress bar.
  virtual std::int64_t bytes_read() const = 0;
};

}  // namespace mikromakro
