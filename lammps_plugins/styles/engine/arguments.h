// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the arguments of a style in an input script one by one. Invalid input stops the run on all ranks with
// one line: the style, the argument, what was expected and what was found.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

// Stops the run on all ranks with "style: what". Collective.
[[noreturn]] void stop(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what);

class Arguments {
 public:
  // Starts at arg[first].
  Arguments(LAMMPS_NS::LAMMPS& engine, std::string style, int narg, char** arg, int first = 0)
      : engine_(engine), style_(std::move(style)), count_(narg), next_(first), arguments_(arg) {}

  [[nodiscard]] bool more() const { return next_ < count_; }
  // Consumes the next argument if it is `keyword`.
  bool take(std::string_view keyword);
  // As take(), but a repeated keyword is an error.
  bool take_once(std::string_view keyword);

  // As take_once(), and consumes "on" or "off" after the keyword, which sets `value`.
  bool take_switch(const std::string& keyword, bool& value);

  // `name` is the argument's name in the documentation, for error messages.
  std::string word(const std::string& name);
  double number(const std::string& name);
  double positive(const std::string& name);
  double not_negative(const std::string& name);
  long integer(const std::string& name, long least, long most);

  [[noreturn]] void fail(const std::string& what) const { stop(engine_, style_, what); }
  // Reports an argument that is none of the accepted keywords: lists them and suggests the closest match.
  [[noreturn]] void unexpected(const std::string& accepted);

 private:
  [[noreturn]] void expected(const std::string& name, const std::string& what, const std::string& found);

  LAMMPS_NS::LAMMPS& engine_;
  std::string style_;
  int count_;
  int next_;
  char** arguments_;
  std::set<std::string, std::less<>> taken_once_;
};

// 'word', followed by the most similar word in `names`, if there is one.
std::string quoted_with_guess(const std::string& word, const std::string& names);

// A number formatted as users write it: 0.0053, not 0.005300000.
std::string text_of(double value);

}  // namespace mikromakro::styles
