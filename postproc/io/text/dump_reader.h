// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of a LAMMPS / LIGGGHTS text dump (`dump custom`, `dump local`): parses headers and cuts out rows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/line_reader.h"
#include "model/frame.h"

namespace mikromakro {

/// Header of one frame.
struct DumpHeader {
  std::int64_t step = 0;
  std::int64_t rows = 0;
  Box box;
  double depth = 0;         ///< of the box in the third dimension
  double time = not_given;  ///< of ITEM: TIME, in the units of the file
  std::string units;        ///< of ITEM: UNITS, which precedes the first frame only; empty: not named
  std::string label;        ///< "ATOMS" for particles, "ENTRIES" (or the dump_modify label) for a local dump
  std::vector<std::string> columns;  ///< empty: not named in the file
  std::int64_t line = 0;             ///< line of the column names

  std::int64_t order() const { return step; }
  bool same_time(const DumpHeader& other) const { return step == other.step; }
  std::string time_text() const { return "step " + std::to_string(step); }
  bool of_particles() const { return label == "ATOMS"; }
};

/// The unparsed rows below one header; row i is line header.line + 1 + i.
struct RowBlock {
  std::string file;
  DumpHeader header;
  std::string text;  ///< whole lines, line ends included
};

/// Throws (bad input, with file and line) on anything that is not a dump: unknown or missing items, malformed
/// counts, fewer rows than announced, lines after the last row that do not begin a frame. A truncated
/// compressed file ends before its incomplete frame.
class DumpReader {
 public:
  using Header = DumpHeader;
  using Block = RowBlock;
  static constexpr std::string_view not_ascending = "time steps do not increase";
  static constexpr bool has_pieces = true;

  explicit DumpReader(const std::string& file) : lines_(file) {}

  /// Reads the next header, after skipping rows that were not taken; false at the end of the file.
  bool next_header(DumpHeader& header);

  /// Cuts out the rows below the last header; none if a truncated file ends among them. Another frame or the
  /// end of the file must follow, so that a count that is too small never drops rows silently.
  std::optional<RowBlock> take_rows(const DumpHeader& header);

  /// At the end: the compressed data were truncated, and the last frame is left out.
  bool cut() const { return lines_.cut(); }

  Place place() const { return lines_.place(); }
  const std::string& file() const { return lines_.file(); }
  std::int64_t bytes_read() const { return lines_.bytes_read(); }

 private:
  struct CutFile {};  // thrown if the file ends within a header

  bool cut_rows(std::string& text);
  void check_frames() const;
  void end_frame();
  void read_header(DumpHeader& header);
  std::string_view read_preface(DumpHeader& header);
  Error not_a_frame(std::string_view line) const;
  std::string_view header_line(std::string_view expected);
  std::int64_t count_line(std::string_view what);
  void read_box(std::string_view flags, DumpHeader& header);
  bool read_item(std::string_view item, DumpHeader& header);

  LineReader lines_;
  std::int64_t frames_ = 0;  ///< complete frames so far
  std::int64_t rows_ = 0;    ///< of the last header, until they are taken
  std::string units_;        ///< as named in the file so far
  std::string ahead_;        ///< the first line of the next frame, if end_frame has read it
};

}  // namespace mikromakro
