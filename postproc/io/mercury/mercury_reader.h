// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of MercuryDPM files: .data (particles) and .fstat (contacts). Parses headers and cuts out rows.
//
// Source of the layout: DPMBase::outputXBallsData, readNextDataFile, writeFstatHeader and
// BaseInteraction::writeToFStat of MercuryDPM (www.mercurydpm.org).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/line_reader.h"
#include "model/frame.h"

namespace mikromakro {

/// Range of particle radii in a frame, m.
struct Radii {
  double smallest = 0, largest = 0;
};

/// Header of one frame: in .data `N time xmin ymin xmax ymax` (rows of 8 columns) or `N time xmin ymin zmin
/// xmax ymax zmax` (14 columns); in .fstat three lines that begin with #: the time, the bounds, and the
/// smallest and largest interaction radius, which is the particle radius without cohesion.
struct MercuryHeader {
  double time = 0;
  std::int64_t rows = 0;       ///< .data only
  std::optional<Box> box;      ///< .fstat: if its second line holds six bounds
  std::optional<Radii> radii;  ///< .fstat: if its third line begins with them
  int columns = 0;
  std::int64_t line = 0;  ///< last line of the header

  std::int64_t step = 0;  ///< index of the frame in its file, from 0

  double order() const { return time; }
  /// Equal to six digits, the minimum in the files.
  bool same_time(const MercuryHeader& other) const;
  std::string time_text() const;
};

/// The rows below one header as text; row i is line header.line + 1 + i.
struct MercuryBlock {
  std::string file;
  MercuryHeader header;
  std::string text;
  bool may_be_cut = false;  ///< rows extend to the end of the file and their number is not known
};

/// Common to both kinds of files: headers, which the subclasses parse, each followed by rows.
class MercuryReader {
 public:
  using Header = MercuryHeader;
  using Block = MercuryBlock;
  static constexpr std::string_view not_ascending = "times do not increase";
  static constexpr bool has_pieces = false;

  /// None if a truncated compressed file ends among the rows (in .fstat: anywhere after the header).
  std::optional<MercuryBlock> take_rows(const MercuryHeader& header);
  bool cut() const { return lines_.cut(); }

  const std::string& file() const { return lines_.file(); }
  std::int64_t bytes_read() const { return lines_.bytes_read(); }

 protected:
  static constexpr std::int64_t to_the_next_header = std::numeric_limits<std::int64_t>::max();

  explicit MercuryReader(const std::string& file) : lines_(file) {}
  /// The first line of the next header, after skipping rows that were not taken and empty lines, which may
  /// end a file. False at the end. Throws if the file, which should be of kind `kind`, is empty.
  bool next_frame(std::string_view& line, std::string_view kind);

  LineReader lines_;
  std::int64_t frames_ = 0;  ///< headers read so far
  std::int64_t rows_ = 0;    ///< of the last header, until they are taken

 private:
  bool cut_rows(std::string& text);
};

/// Throws if this is not a .data file: a header of the wrong length, fewer rows than it announces.
class MercuryDataReader : public MercuryReader {
 public:
  explicit MercuryDataReader(const std::string& file) : MercuryReader(file) {}
  /// Whether a file begins like a .data file, with a number followed by others.
  static bool recognises(const std::string& file);
  bool next_header(MercuryHeader& header);
};

/// Throws if this is not an .fstat file. The format does not give the number of rows: a file truncated
/// between two lines of its last frame looks complete.
class MercuryFstatReader : public MercuryReader {
 public:
  explicit MercuryFstatReader(const std::string& file) : MercuryReader(file) {}
  /// Whether a file begins like an .fstat file, with # and the time.
  static bool recognises(const std::string& file);
  bool next_header(MercuryHeader& header);

 private:
  std::vector<std::string_view> header_words(std::string_view expected);
};

}  // namespace mikromakro
