#include "io/dump_reader.h"

#include <fmt/format.h>

#include "io/row_parser.h"

namespace mikromakro {
namespace {

constexpr std::string_view item_mark = "ITEM: ";
constexpr std::string_view number_of = "NUMBER OF ";
constexpr std::string_view box_bounds = "BOX BOUNDS";

}  // namespace

bool DumpReader::next_header(DumpHeader& header) {
  if (rows_ > 0) {
    std::string skipped;
    cut_rows(skipped);
  }
  end_frame();
  std::string_view line = ahead_;
  if (line.empty()) {
    if (lines_.line() == 0) throw bad_input({file()}, "the file is empty", "a text dump", "no line");
    return false;
  }
  // LAMMPS writes the units before the first frame and the time before the step when asked to.
  while (line == "ITEM: UNITS" || line == "ITEM: TIME") {
    header_line("a value");
    line = header_line("'ITEM: TIMESTEP'");
  }
  if (line != "ITEM: TIMESTEP") throw not_a_frame(line);
  ahead_.clear();
  header = DumpHeader{};
  header.step = count_line("time step");
  while (read_item(header_line("'ITEM: '"), header)) {
  }
  return true;
}

void DumpReader::end_frame() {
  std::string_view line;
  while (ahead_.empty() && lines_.next(line)) {
    // Empty lines may end a file.
    if (line.empty() && lines_.line() > 1) continue;
    if (!line.starts_with(item_mark)) throw not_a_frame(line);
    ahead_ = line;
  }
}

Error DumpReader::not_a_frame(std::string_view line) const {
  return bad_input(place(), "not the start of a frame", "'ITEM: TIMESTEP' or the end of the file",
                   in_quotes(line));
}

std::string_view DumpReader::header_line(std::string_view expected) {
  std::string_view line;
  if (!lines_.next(line))
    throw bad_input(place(), "the file ends within a header", expected, "the end of the file");
  return line;
}

std::int64_t DumpReader::count_line(std::string_view what) {
  const std::string_view line = header_line(what);
  const auto found = words(line);
  if (found.size() != 1)
    throw bad_input(place(), fmt::format("no {}", what), "one whole number", in_quotes(line));
  const std::int64_t count = parse_integer(found[0], place());
  if (count < 0) throw bad_input(place(), fmt::format("negative {}", what), "0 or more", in_quotes(line));
  return count;
}

// Reads one item of the header; false when it was the line with the column names, the last one.
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
    read_box(item.substr(box_bounds.size()), header.box);
    return true;
  }
  if (header.label.empty())
    throw bad_input(place(), "no number of rows", "'ITEM: NUMBER OF'", in_quotes(line));
  if (!item.starts_with(header.label))
    throw bad_input(place(), "no column names", fmt::format("'ITEM: {}'", header.label), in_quotes(line));
  for (const std::string_view name : words(item.substr(header.label.size())))
    header.columns.emplace_back(name);
  if (header.columns.empty())
    throw bad_input(place(), "no column names", "names after the label", in_quotes(line));
  header.line = lines_.line();
  rows_ = header.rows;
  return false;
}

void DumpReader::read_box(std::string_view flags, Box& box) {
  const auto kinds = words(flags);
  if (!kinds.empty() && kinds.size() != 3)
    throw bad_input(place(), "box is not orthogonal", "three boundary flags or none", in_quotes(flags));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view line = header_line("box bounds");
    const auto bounds = words(line);
    if (bounds.size() != 2) throw bad_input(place(), "box bounds", "low and high", in_quotes(line));
    if (axis == 2) break;
    const auto index = static_cast<Eigen::Index>(axis);
    box.low[index] = parse_number(bounds[0], place());
    box.high[index] = parse_number(bounds[1], place());
    box.periodic[axis] = !kinds.empty() && kinds[axis] == "pp";
    if (box.low[index] > box.high[index])
      throw bad_input(place(), "box bounds are not in order", "low <= high", in_quotes(line));
  }
}

RowBlock DumpReader::take_rows(const DumpHeader& header) {
  RowBlock block{file(), header, {}};
  cut_rows(block.text);
  end_frame();
  return block;
}

void DumpReader::cut_rows(std::string& text) {
  const std::int64_t got = lines_.take(rows_, item_mark, text);
  if (got < rows_) {
    std::string_view line;
    const bool more = lines_.next(line);
    throw bad_input(place(), more ? "the frame ends early" : "the file ends within a frame",
                    fmt::format("{} rows", rows_), fmt::format("{}", got));
  }
  rows_ = 0;
}

}  // namespace mikromakro
