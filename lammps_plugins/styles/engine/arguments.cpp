// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/arguments.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "error.h"
#include "lammps.h"
#include "model/nearest_name.h"

namespace mikromakro::styles {
namespace {

// The whole text must be a number; the engine's own parser accepts "1.5.3" and "--".
template <class Number>
bool parse(std::string_view text, Number& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

std::string quoted(const std::string& text) {
  return std::string("'").append(text).append("'");
}

bool in_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '/';
}

}  // namespace

std::string quoted_with_guess(const std::string& word, const std::string& names) {
  std::vector<std::string_view> known;
  for (auto begin = names.begin(); begin != names.end();) {
    const auto end = std::find_if_not(begin, names.end(), in_word);
    if (end - begin > 2) known.emplace_back(begin, end);
    begin = std::find_if(end, names.end(), in_word);
  }
  return in_quotes_with_guess(word, known);
}

void stop(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what) {
  engine.error->all(FLERR, (style + ": " + what).c_str());
  std::abort();  // not reached: the engine ends the process
}

bool Arguments::take(std::string_view keyword) {
  if (!more() || keyword != arguments_[next_]) return false;
  ++next_;
  return true;
}

bool Arguments::take_once(std::string_view keyword) {
  if (!take(keyword)) return false;
  if (!taken_once_.emplace(keyword).second) fail(std::string(keyword) + ": expected it once, got it twice");
  return true;
}

bool Arguments::take_switch(const std::string& keyword, bool& value) {
  if (!take_once(keyword)) return false;
  const std::string found = more() ? word(keyword) : "nothing";
  if (found != "on" && found != "off") fail("'" + keyword + "': expected on or off, got " + found);
  value = found == "on";
  return true;
}

std::string Arguments::word(const std::string& name) {
  if (!more()) expected(name, "a word", "the end of the command");
  return arguments_[next_++];
}

double Arguments::number(const std::string& name) {
  if (!more()) expected(name, "a number", "the end of the command");
  const std::string text = arguments_[next_++];
  double value = 0.0;
  if (!parse(text, value) || !std::isfinite(value)) expected(name, "a number", quoted(text));
  return value;
}

double Arguments::positive(const std::string& name) {
  const double value = number(name);
  if (value <= 0.0) expected(name, "a positive number", text_of(value));
  return value;
}

double Arguments::not_negative(const std::string& name) {
  const double value = number(name);
  if (value < 0.0) expected(name, "a number that is not negative", text_of(value));
  return value;
}

long Arguments::integer(const std::string& name, long least, long most) {
  const std::string wanted = "an integer from " + std::to_string(least) + " to " + std::to_string(most);
  if (!more()) expected(name, wanted, "the end of the command");
  const std::string text = arguments_[next_++];
  long value = 0;
  if (!parse(text, value) || value < least || value > most) expected(name, wanted, quoted(text));
  return value;
}

void Arguments::unexpected(const std::string& accepted) {
  fail("expected " + accepted + ", got " +
       (more() ? quoted_with_guess(arguments_[next_], accepted) : std::string("the end of the command")));
}

void Arguments::expected(const std::string& name, const std::string& what, const std::string& found) {
  fail(name + ": expected " + what + ", got " + found);
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace mikromakro::styles
