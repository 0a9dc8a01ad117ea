// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/dump_reader.h"

#include <fmt/format.h>

#include "io/files/row_parser.h"

namespace mikromakro {
namespace {

constexpr std::string_view item_mark = "ITEM: ";
constexpr std::string_view number_of = "NUMBER OF ";
constexpr std::string_view box_bounds = "BOX BOUNDS";

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Boundary flags of all engines: one letter per side (LAMMPS, LIGGGHTS), or one for both.
bool is_periodic(std::string_view word, const Place& place) {
  constexpr std::string_view letters = "pfsm";
  const bool known = !word.empty() && word.size() <= 2 &&
                     word.find_first_not_of(letters) == std::string_view::npos &&
                     (word[0] == 'p') == (word.back() == 'p');
  if (!known)
    throw bad_input(place, "not a boundary of a box", "pp, ff, ss, fs, mm, ... or p, f, s, m",
                    in_quotes(word));
  return word[0] == 'p';
}

}  // namespace

bool DumpReader::next_header(DumpHeader& header) {
  std::string skipped;
  if (rows_ > 0 && !cut_rows(skipped)) return false;
  end_frame();
  if (ahead_.empty()) {
    if (cut()) check_frames();
    if (lines_.line() == 0) throw bad_input({file()}, "the file is empty", "a text dump", "no line");
    return false;
  }
  header = DumpHeader{};
  try {
    read_header(header);
  } catch (const CutFile&) {
    check_frames();
    return false;
  }
  return true;
}

void DumpReader::check_frames() const {
  if (frames_ == 0)
    throw bad_input(place(), "the compressed file is truncated", "at least one complete frame", "none");
}

void DumpReader::read_header(DumpHeader& header) {
  const std::string_view line = read_preface(header);
  if (line != "ITEM: TIMESTEP") throw not_a_frame(line);
  ahead_.clear();
  header.box.boundaries_known = false;  // unless the header gives them
  header.step = count_line("time step");
  while (read_item(header_line("'ITEM: '"), header)) {
  }
  header.units = units_;
}

// On request, LAMMPS writes the units before the first frame and the time before the step.
std::string_view DumpReader::read_preface(DumpHeader& header) {
  std::string_view line = ahead_;
  while (line == "ITEM: UNITS" || line == "ITEM: TIME") {
    const bool of_units = line == "ITEM: UNITS";
    const std::string_view value = header_line("a value");
    if (of_units) {
      if (!units_.empty() && units_ != value)
        throw bad_input(place(), "the units change", in_quotes(units_), in_quotes(value));
      units_ = value;
    } else {
      header.time = parse_number(value, place());
    }
    line = header_line("'ITEM: TIMESTEP'");
  }
  return line;
}

void DumpReader::end_frame() {
  std::string_view line;
  while (ahead_.empty() && lines_.next(line)) {
    // Empty lines may end a file.
    if (trimmed(line).empty() && lines_.line() > 1) continue;
    if (!line.starts_with(item_mark)) throw not_a_frame(line);
    ahead_ = trimmed(line);
  }
}

Error DumpReader::not_a_frame(std::string_view line) const {
  return bad_input(place(), "not the start of a frame", "'ITEM: TIMESTEP' or the end of the file",
                   in_quotes(line));
}

std::string_view DumpReader::header_line(std::string_view expected) {
  std::string_view line;
  if (lines_.next(line)) return trimmed(line);
  if (cut()) throw CutFile();
  throw bad_input(place(), "the file ends within a header", expected, "the end of the file");
}

std::int64_t DumpReader::count_line(std::string_view what) {
  const std::string_view line = header_line(what);
  const auto found = words(line);
  if (found.size() != 1)
    throw bad_input(place(), fmt::format("no {}", what), "one whole number", in_quotes(line));
  const std::int64_t count = as_integer(parse_number(found[0], place()), what, place());
  if (count < 0) throw bad_input(place(), fmt::format("negative {}", what), "0 or more", in_quotes(line));
  return count;
}

// Reads one item of the header; false after the last item, the line with the column names.
bool DumpReader::read_item(std::string_view line, DumpHeader& header) {
  if (!line.starts_with(item_mark))
    throw bad_input(place(), "not a header line", "'ITEM: '", in_quotes(line));
  std::string_view item = line.substr(item_mark.size());
  if (item.starts_with(number_of)) {
    header.label = std::string(item.substr(number_of.size()));
    header.rows = count_line("number of rows");
    return true;
  }
  if (item.starts_with(box_bounds)) {
    read_box(item.substr(box_bounds.size()), header);
    return true;
  }
  if (header.label.empty())
    throw bad_input(place(), "no number of rows", "'ITEM: NUMBER OF'", in_quotes(line));
  if (!item.starts_with(header.label))
    throw bad_input(place(), "no column names", fmt::format("'ITEM: {}'", header.label), in_quotes(line));
  for (const std::string_view name : words(item.substr(header.label.size())))
    header.columns.emplace_back(name);
  header.line = lines_.line();
  rows_ = header.rows;
  return false;
}

void DumpReader::read_box(std::string_view flags, DumpHeader& header) {
  Box& box = header.box;
  const auto kinds = words(flags);
  // Tilted boxes have 'xy xz yz' or 'abc origin' before the boundary flags.
  if (!kinds.empty() && (kinds.size() != 3 || kinds[0] == "xy" || kinds[0] == "abc"))
    throw bad_input(place(), "box is not orthogonal", "three boundary flags or none", in_quotes(flags));
  box.boundaries_known = !kinds.empty();
  // The words are views that the next line invalidates.
  for (std::size_t axis = 0; axis < 2 && !kinds.empty(); ++axis) {
    box.periodic[axis] = is_periodic(kinds[axis], place());
    box.wrapped[axis] = kinds[axis].find_first_of("sm") != std::string_view::npos;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view line = header_line("box bounds");
    const auto bounds = words(line);
    if (bounds.size() != 2) throw bad_input(place(), "box bounds", "low and high", in_quotes(line));
    const double low = parse_number(bounds[0], place());
    const double high = parse_number(bounds[1], place());
    if (low > high) throw bad_input(place(), "box bounds are not in order", "low <= high", in_quotes(line));
    if (axis == 2) {
      header.depth = high - low;
    } else {
      box.low[static_cast<Eigen::Index>(axis)] = low;
      box.high[static_cast<Eigen::Index>(axis)] = high;
    }
  }
}

std::optional<RowBlock> DumpReader::take_rows(const DumpHeader& header) {
  RowBlock block{file(), header, {}};
  if (!cut_rows(block.text)) return std::nullopt;
  end_frame();
  return block;
}

// False if a truncated file ends among the rows.
bool DumpReader::cut_rows(std::string& text) {
  const std::int64_t rows = rows_;
  const std::int64_t got = lines_.take(rows, item_mark, text);
  rows_ = 0;
  if (got == rows) {
    ++frames_;
    return true;
  }
  std::string_view line;
  const bool more = lines_.next(line);
  if (!more && cut()) {
    check_frames();
    return false;
  }
  throw bad_input(place(), more ? "the frame ends early" : "the file ends within a frame",
                  fmt::format("{} rows", rows), fmt::format("{}", got));
}

}  // namespace mikromakro
