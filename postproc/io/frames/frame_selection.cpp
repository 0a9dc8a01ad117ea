// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/frames/frame_selection.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "io/files/row_parser.h"
#include "model/error.h"

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
  if (!text.empty()) value = parse_integer(text, place);
}

void check_order(std::int64_t first, std::int64_t last, const Place& place, const std::string& text) {
  if (first > last) throw bad_input(place, "the range is empty", "first <= last", in_quotes(text));
}

void refuse_negative(std::int64_t value, const Place& place, const std::string& text) {
  if (value < 0) throw bad_input(place, "negative number", "0 or more", in_quotes(text));
}

}  // namespace

FrameSelection FrameSelection::none() {
  FrameSelection selection;
  selection.last_step = -1;
  return selection;
}

FrameSelection FrameSelection::among(std::int64_t frames) const {
  FrameSelection selection = *this;
  if (last < 0) selection.last += frames;
  if (first < 0) selection.first += frames;
  // A missing single frame selects nothing; a range is clipped to the existing frames.
  if (selection.last < 0) return none();
  selection.first = std::max<std::int64_t>(selection.first, 0);
  return selection;
}

void select_frames(const std::string& text, FrameSelection& selection) {
  const Place place{"--frames"};
  const auto parts = split(text);
  if (text.empty() || parts.size() > 3)
    throw bad_input(place, "not a range", "FIRST:LAST[:STEP] or one frame", in_quotes(text));
  set_if_given(parts[0], place, selection.first);
  if (parts.size() == 1) selection.last = selection.first;
  if (parts.size() > 1) set_if_given(parts[1], place, selection.last);
  if (parts.size() == 3) set_if_given(parts[2], place, selection.stride);
  if (selection.stride < 1)
    throw bad_input(place, "the stride is not positive", "1 or more", in_quotes(text));
  if ((selection.first < 0) == (selection.last < 0))
    check_order(selection.first, selection.last, place, text);
}

void select_steps(const std::string& text, FrameSelection& selection) {
  const Place place{"--steps"};
  const auto parts = split(text);
  if (text.empty() || parts.size() > 2)
    throw bad_input(place, "not a range", "FIRST:LAST or one step", in_quotes(text));
  set_if_given(parts[0], place, selection.first_step);
  if (parts.size() == 1) selection.last_step = selection.first_step;
  if (parts.size() > 1) set_if_given(parts[1], place, selection.last_step);
  refuse_negative(selection.first_step, place, text);
  refuse_negative(selection.last_step, place, text);
  check_order(selection.first_step, selection.last_step, place, text);
}

}  // namespace mikromakro
