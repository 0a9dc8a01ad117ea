// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of one frame that are spread over several files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/error.h"

namespace mikromakro {

/// Rows from number `begin` on are in another file, starting at its line `first_line`.
struct FurtherPiece {
  std::size_t begin = 0;
  std::string file;
  std::int64_t first_line = 0;
};

/// Location of row i: relative to `place` unless a further piece holds it.
inline Place place_of_row(std::size_t i, Place place, const std::vector<FurtherPiece>& pieces) {
  for (const FurtherPiece& piece : pieces)
    if (i >= piece.begin) place = {piece.file, piece.first_line + static_cast<std::int64_t>(i - piece.begin)};
  return place;
}

}  // namespace mikromakro
