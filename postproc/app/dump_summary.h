// SPDX-License-Identifier: GPL-2.0-or-later
// Output of `info` for text dumps.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "io/tables/json.h"
#include "io/text/dump_reader.h"
#include "model/notes.h"

namespace mikromakro {

/// Lengths in m if the file names units with SI values.
struct DumpSummary {
  std::int64_t frames = 0;
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
  std::int64_t fewest_rows = std::numeric_limits<std::int64_t>::max();
  std::int64_t most_rows = 0;
  DumpHeader last;
  /// Fewest and most in the last frame of each file.
  struct Count {
    std::int64_t fewest = 0, most = 0;
  };
  std::map<int, Count> counts_by_type;  ///< empty: no types
  double smallest_radius = std::numeric_limits<double>::infinity();
  double largest_radius = 0;  ///< 0: no radii
};

/// Reads the whole file; warnings go to the notes.
DumpSummary summarise_dump(const std::string& file, const std::vector<std::string>& particle_columns,
                           Notes& notes);

/// Whether two files are parts of one dump: the same kind, columns and units.
bool alike(const DumpSummary& one, const DumpSummary& other);
/// Adds a further part; the box is that of the later one.
void add_part(const DumpSummary& part, DumpSummary& whole);

void print_dump(const std::string& file, const DumpSummary& summary);
Json dump_json(const std::string& file, const DumpSummary& summary);

}  // namespace mikromakro
