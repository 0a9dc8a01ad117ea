// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of MercuryDPM's files: .data (particles) and .fstat (contacts), headers read, rows cut out.
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

/// Of the particles of a frame, m.
struct Radii {
  double smallest = 0, largest = 0;
};

/// What stands above the rows of one frame: in .data `N time xmin ymin xmax ymax` (rows of 8 columns) or
/// `N time xmin ymin zmin xmax ymax zmax` (14 columns), in .fstat three lines that begin with #: the time,
/// the bounds, and the smallest and the largest radius of interaction, which is the radius without cohesion.
struct MercuryHeader {
  double time = 0;
  std::int64_t rows = 0;       ///< .data only
  std::optional<Box> box;      ///< .fstat: where its second line holds six bounds
  std::optional<Radii> radii;  ///< .fstat: where its third line begins with them
  int columns = 0;
  std::int64_t line = 0;  ///< the last one of the header

  std::int64_t step = 0;  ///< the number of the frame in its file, from 0

  double order() const { return time; }
  /// Within the six digits that the files have at least.
  bool same_time(const MercuryHeader& other) const;
  std::string time_text() const;
};

/// The rows below one header as text; row i is line header.line + 1 + i.
struct MercuryBlock {
  std::string file;
  MercuryHeader header;
  std::string text;
  bool may_be_cut = false;  ///< rows up to the end of the file, where no header says how many there should be
};

/// What both kinds of files have in common: frames, headers of which the kinds read, and rows below them.
class MercuryReader {
 public:
  using Header = MercuryHeader;
  using Block = MercuryBlock;
  static constexpr std::string_view not_ascending = "times do not ascend";
  static constexpr bool has_pieces = false;

  /// Nothing where a compressed file was cut among them (in .fstat: anywhere behind the header).
  std::optional<MercuryBlock> take_rows(const MercuryHeader& header);
  bool cut() const { return lines_.cut(); }

  const std::string& file() const { return lines_.file(); }
  std::int64_t bytes_read() const { return lines_.bytes_read(); }

 protected:
  static constexpr std::int64_t to_the_next_header = std::numeric_limits<std::int64_t>::max();

  explicit MercuryReader(const std::string& file) : lines_(file) {}
  /// The first line of the next header; rows that nobody has taken are skipped, and empty lines, which may
  /// end a file. False at the end. Throws where the file, which should be `kind`, is empty.
  bool next_frame(std::string_view& line, std::string_view kind);

  LineReader lines_;
  std::int64_t frames_ = 0;  ///< headers that were read
  std::int64_t rows_ = 0;    ///< of the last header, until they are cut out

 private:
  bool cut_rows(std::string& text);
};

/// Throws whatever is no .data file: a header of another length, fewer rows than it says.
class MercuryDataReader : public MercuryReader {
 public:
  explicit MercuryDataReader(const std::string& file) : MercuryReader(file) {}
  /// Whether a file begins as .data files do, with a number and others behind it.
  static bool recognises(const std::string& file);
  bool next_header(MercuryHeader& header);
};

/// Throws whatever is no .fstat file. It does not say how many rows a frame has: a file that was cut between
/// two lines of its last frame looks complete.
class MercuryFstatReader : public MercuryReader {
 public:
  explicit MercuryFstatReader(const std::string& file) : MercuryReader(file) {}
  /// Whether a file begins as .fstat files do, with # and the time.
  static bool recognises(const std::string& file);
  bool next_header(MercuryHeader& header);

 private:
  std::vector<std::string_view> header_words(std::string_view expected);
};

}  // namespace mikromakro
