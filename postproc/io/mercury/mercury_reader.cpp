// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/mercury/mercury_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "io/files/row_parser.h"

namespace mikromakro {
namespace {

constexpr std::string_view comment = "#";

std::string first_line(const std::string& file) {
  LineReader lines(file);
  std::string_view line;
  return lines.next(line) ? std::string(line) : std::string();
}

bool begins_with_digit(std::string_view word) {
  return !word.empty() && word[0] >= '0' && word[0] <= '9';
}

// From the lower and upper bounds in two or three dimensions.
Box box_of(std::span<const std::string_view> bounds, const Place& place) {
  Box box;
  box.boundaries_known = false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto index = static_cast<Eigen::Index>(axis);
    box.low[index] = parse_number(bounds[axis], place);
    box.high[index] = parse_number(bounds[bounds.size() / 2 + axis], place);
  }
  if ((box.low.array() > box.high.array()).any())
    throw bad_input(place, "box bounds are not in order", "low <= high",
                    in_quotes(fmt::format("{}", fmt::join(bounds, " "))));
  return box;
}

}  // namespace

bool MercuryHeader::same_time(const MercuryHeader& other) const {
  constexpr double tolerance = 1e-5;
  return std::abs(time - other.time) <= tolerance * std::max(std::abs(time), std::abs(other.time));
}

std::string MercuryHeader::time_text() const {
  return fmt::format("time {}", time);
}

bool MercuryReader::next_frame(std::string_view& line, std::string_view kind) {
  std::string skipped;
  if (rows_ > 0 && !cut_rows(skipped)) return false;
  while (lines_.next(line))
    if (!words(line).empty()) return true;
  if (lines_.line() == 0) throw bad_input({file()}, "the file is empty", kind, "no line");
  return false;
}

std::optional<MercuryBlock> MercuryReader::take_rows(const MercuryHeader& header) {
  MercuryBlock block{file(), header, {}};
  const bool counted = rows_ != to_the_next_header;
  if (!cut_rows(block.text)) return std::nullopt;
  block.may_be_cut = !counted && lines_.at_end();
  return block;
}

// False if a truncated file ends among the rows.
bool MercuryReader::cut_rows(std::string& text) {
  const std::int64_t rows = rows_;
  const std::int64_t got = lines_.take(rows, comment, text);
  rows_ = 0;
  if (got == rows) return true;
  if (lines_.cut()) return false;
  if (rows != to_the_next_header)
    throw bad_input(lines_.place(), "the file ends within a frame", fmt::format("{} rows", rows),
                    fmt::format("{}", got));
  return true;
}

bool MercuryDataReader::recognises(const std::string& file) {
  const std::string line = first_line(file);
  std::string_view rest = line;
  // A single number is the first line of an xyz file.
  return begins_with_digit(next_word(rest)) && !next_word(rest).empty();
}

bool MercuryDataReader::next_header(MercuryHeader& header) {
  std::string_view line;
  if (!next_frame(line, "a .data file")) return false;
  const Place place = lines_.place();
  const auto found = words(line);
  if (found.size() != 6 && found.size() != 8)
    throw bad_input(place, "not the header of a .data frame", "N time and 4 or 6 bounds", in_quotes(line));
  header = {};
  header.rows = parse_integer(found[0], place);
  if (header.rows < 0) throw bad_input(place, "negative number of rows", "0 or more", in_quotes(line));
  header.time = parse_number(found[1], place);
  const std::size_t dimensions = found.size() / 2 - 1;
  header.box = box_of(std::span(found).subspan(2), place);
  header.columns = dimensions == 2 ? 8 : 14;
  header.line = lines_.line();
  header.step = frames_++;
  rows_ = header.rows;
  return true;
}

bool MercuryFstatReader::recognises(const std::string& file) {
  const std::string line = first_line(file);
  std::string_view rest = line;
  return next_word(rest) == comment && begins_with_digit(next_word(rest));
}

std::vector<std::string_view> MercuryFstatReader::header_words(std::string_view expected) {
  std::string_view line;
  if (!lines_.next(line))
    throw bad_input(lines_.place(), "the file ends within a header", expected, "the end of the file");
  if (!line.starts_with(comment))
    throw bad_input(lines_.place(), "not the header of an .fstat frame", expected, in_quotes(line));
  return words(line.substr(comment.size()));
}

bool MercuryFstatReader::next_header(MercuryHeader& header) {
  std::string_view line;
  if (!next_frame(line, "an .fstat file")) return false;
  const auto found = words(line);
  if (found.size() < 2 || found[0] != comment)
    throw bad_input(lines_.place(), "not the header of an .fstat frame", "# time", in_quotes(line));
  header = {};
  header.time = parse_number(found[1], lines_.place());
  header.columns = 16;
  const auto bounds = header_words("# with the bounds");
  if (bounds.size() == 6) header.box = box_of(bounds, lines_.place());
  const auto radii = header_words("# with the radii");
  if (radii.size() >= 2)
    header.radii = Radii{parse_number(radii[0], lines_.place()), parse_number(radii[1], lines_.place())};
  header.line = lines_.line();
  header.step = frames_++;
  rows_ = to_the_next_header;
  return true;
}

}  // namespace mikromakro
