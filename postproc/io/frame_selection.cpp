#include "io/frame_selection.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "io/error.h"
#include "io/row_parser.h"

namespace mikromakro {
namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':')) {
    parts.push_back(text.substr(0, colon));
    text.remove_prefix(colon + 1);
  }
  parts.push_back(text);
  return parts;
}

void set_if_given(std::string_view text, const Place& place, std::int64_t& value) {
  if (text.empty()) return;
  value = parse_integer(text, place);
  if (value < 0) throw bad_input(place, "negative number", "0 or more", in_quotes(text));
}

void check_order(std::int64_t first, std::int64_t last, const Place& place, const std::string& text) {
  if (first > last) throw bad_input(place, "the range is empty", "first <= last", in_quotes(text));
}

}  // namespace

void select_frames(const std::string& text, FrameSelection& selection) {
  const Place place{"--frames"};
  const auto parts = split(text);
  if (parts.size() < 2 || parts.size() > 3)
    throw bad_input(place, "not a range", "FIRST:LAST[:STEP]", in_quotes(text));
  set_if_given(parts[0], place, selection.first);
  set_if_given(parts[1], place, selection.last);
  if (parts.size() == 3) set_if_given(parts[2], place, selection.stride);
  if (selection.stride < 1)
    throw bad_input(place, "the stride is not positive", "1 or more", in_quotes(text));
  check_order(selection.first, selection.last, place, text);
}

void select_steps(const std::string& text, FrameSelection& selection) {
  const Place place{"--steps"};
  const auto parts = split(text);
  if (parts.size() != 2) throw bad_input(place, "not a range", "FIRST:LAST", in_quotes(text));
  set_if_given(parts[0], place, selection.first_step);
  set_if_given(parts[1], place, selection.last_step);
  check_order(selection.first_step, selection.last_step, place, text);
}

}  // namespace mikromakro
