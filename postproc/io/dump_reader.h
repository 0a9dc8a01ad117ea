// Frames of a LAMMPS / LIGGGHTS text dump (`dump custom`, `dump local`), header by header and row by row.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/frame.h"
#include "io/line_reader.h"

namespace mikromakro {

/// What stands above the rows of one frame.
struct DumpHeader {
  std::int64_t step = 0;
  std::int64_t rows = 0;
  Box box;
  std::string label;  ///< "ATOMS" for particles, "ENTRIES" (or what dump_modify label says) for a local dump
  std::vector<std::string> columns;
  std::int64_t line = 0;  ///< of the line with the column names

  bool of_particles() const { return label == "ATOMS"; }
};

/// Throws (bad input, with file and line) on whatever is not a dump: unknown or missing items, counts that
/// are none, fewer rows than the header says, lines after the last row that do not begin a frame.
class DumpReader {
 public:
  explicit DumpReader(const std::string& file) : lines_(file) {}

  /// Reads the next header, after skipping rows that were not read; false at the end of the file.
  bool next_header(DumpHeader& header);

  /// The next row of the frame; to be called at most header.rows times.
  std::string_view next_row();

  /// To be called after the last row: what follows must be another frame or the end of the file, so that a
  /// count that is too small drops no row silently. Invalidates the last row.
  void end_frame();

  Place place() const { return lines_.place(); }
  const std::string& file() const { return lines_.file(); }
  std::int64_t bytes_read() const { return lines_.bytes_read(); }

 private:
  Error not_a_frame(std::string_view line) const;
  std::string_view header_line(std::string_view expected);
  std::int64_t count_line(std::string_view what);
  void read_box(std::string_view flags, Box& box);
  bool read_item(std::string_view item, DumpHeader& header);

  LineReader lines_;
  std::int64_t rows_ = 0;
  std::int64_t rows_left_ = 0;
  std::string ahead_;  ///< the first line of the next frame, where end_frame has read it
};

}  // namespace mikromakro
