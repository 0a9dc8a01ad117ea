// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/row_parser.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace mikromakro {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// End of an unused word: the blank after it, or the end of the line. Scans eight bytes at a time.
const char* end_of_word(const char* at, const char* end) {
  constexpr std::uint64_t ones = 0x0101010101010101, highest = 0x80 * ones;
  for (std::uint64_t eight = 0; end - at >= 8 && std::endian::native == std::endian::little; at += 8) {
    std::memcpy(&eight, at, sizeof eight);
    // Sets the highest bit of each byte that is a blank or below; bytes above the first such byte may be
    // wrong.
    const std::uint64_t blanks = (eight - ('!' * ones)) & ~eight & highest;
    if (blanks == 0) continue;
    at += std::countr_zero(blanks) / 8;
    break;
  }
  while (at != end && !is_blank(*at)) ++at;
  return at;
}

// Numbers as C prints them, including a leading '+', which fast_float rejects.
fast_float::from_chars_result number_of(const char* at, const char* end, double& number) {
  const auto result = fast_float::from_chars(at, end, number);
  if (result.ec == std::errc() || end - at < 2 || *at != '+' || at[1] == '-') return result;
  return fast_float::from_chars(at + 1, end, number);
}

// Fast path for well-formed rows, in one pass; false for all others, which parse_other_row examines.
bool parse_plain_row(std::string_view line, const ColumnMap& map, std::span<double> slots) {
  const char* at = line.data();
  const char* const end = at + line.size();
  for (const int slot : map.slot_of_column) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) return false;
    if (slot < 0) {
      at = end_of_word(at, end);
      continue;
    }
    double& number = slots[static_cast<std::size_t>(slot)];
    const auto [stop, code] = number_of(at, end, number);
    if (code != std::errc() || (stop != end && !is_blank(*stop)) || !std::isfinite(number)) return false;
    at = stop;
  }
  while (at != end && is_blank(*at)) ++at;
  return at == end;
}

}  // namespace

std::string_view next_word(std::string_view& rest) {
  const char* begin = rest.data();
  const char* const end = begin + rest.size();
  while (begin != end && is_blank(*begin)) ++begin;
  const char* stop = begin;
  while (stop != end && !is_blank(*stop)) ++stop;
  rest = {stop, static_cast<std::size_t>(end - stop)};
  return {begin, static_cast<std::size_t>(stop - begin)};
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> all;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) all.push_back(word);
  return all;
}

std::string_view next_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

double parse_number(std::string_view word, const Place& place) {
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, code] = number_of(word.data(), end, number);
  // Some versions of fast_float report numbers beyond double, infinity or 0 by then, as out of range.
  const bool is_number = code == std::errc() || code == std::errc::result_out_of_range;
  if (!is_number || stop != end) throw bad_input(place, "not a number", "a number", in_quotes(word));
  if (!std::isfinite(number))
    throw bad_input(place, "not a finite number", "a finite number", in_quotes(word));
  return number;
}

std::int64_t parse_integer(std::string_view word, const Place& place) {
  return as_integer(parse_number(word, place), "the value", place);
}

namespace {

// Slow path, which reports what is wrong.
void parse_other_row(std::string_view line, const ColumnMap& map, std::span<double> slots,
                     const Place& place) {
  std::string_view rest = line;
  std::size_t read = 0;
  for (const int slot : map.slot_of_column) {
    const std::string_view word = next_word(rest);
    if (word.empty()) break;
    if (slot >= 0) slots[static_cast<std::size_t>(slot)] = parse_number(word, place);
    ++read;
  }
  if (read == map.slot_of_column.size() && next_word(rest).empty()) return;
  throw bad_input(place, "wrong number of columns in the row", fmt::format("{}", map.slot_of_column.size()),
                  fmt::format("{}", words(line).size()));
}

void check_repeats(std::string_view line, const ColumnMap& map, std::span<const double> slots,
                   const Place& place) {
  const auto all = words(line);
  for (const auto& [column, slot] : map.repeats) {
    const double first = slots[static_cast<std::size_t>(slot)];
    if (parse_number(all[column], place) != first)
      throw bad_input(place, "a column that occurs twice differs", fmt::format("{} in both", first),
                      in_quotes(all[column]));
  }
}

}  // namespace

void parse_row(std::string_view line, const ColumnMap& map, std::span<double> slots, const Place& place) {
  if (!parse_plain_row(line, map, slots)) parse_other_row(line, map, slots, place);
  if (!map.repeats.empty()) check_repeats(line, map, slots, place);
}

}  // namespace mikromakro
