// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/keywords.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "model/error.h"
#include "model/nearest_name.h"
#include "options/value_checks.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

using Words = std::vector<std::string>;

std::string keyword_of(const CLI::Option& option) {
  std::string name = option.get_lnames().empty() ? option.get_single_name() : option.get_lnames().front();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

bool is_flag(const CLI::Option& option) {
  return option.get_items_expected_max() == 0;
}
bool takes_many(const CLI::Option& option) {
  return option.get_items_expected_max() > 1;
}
// One list of words for each run.
bool takes_lists(const CLI::Option& option) {
  return option.get_inject_separator();
}
bool is_text(const py::handle& value) {
  return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
         py::hasattr(value, "__fspath__");
}
bool is_list(const py::handle& value) {
  return !is_text(value) && py::hasattr(value, "__iter__");
}

[[noreturn]] void refuse(const CLI::Option& option, const char* expected, const py::handle& got) {
  throw py::type_error(fmt::format("{}: expected {}, got {}", keyword_of(option), expected,
                                   py::repr(got).cast<std::string>()));
}

// Numbers with all their digits; NumPy 2 writes its own as np.float64(0.1).
std::string word_of(const CLI::Option& option, const py::handle& value) {
  if (py::isinstance<py::bool_>(value) || value.is_none()) refuse(option, "a number or a text", value);
  if (is_text(value)) return py::module_::import("os").attr("fsdecode")(value).cast<std::string>();
  if (py::hasattr(value, "__index__")) return py::str(py::int_(py::reinterpret_borrow<py::object>(value)));
  if (py::hasattr(value, "__float__"))
    return py::repr(py::float_(value.attr("__float__")().cast<double>())).cast<std::string>();
  refuse(option, "a number or a text", value);
}

Words words_of_list(const CLI::Option& option, const py::handle& value) {
  Words words;
  for (const py::handle& one : py::iter(value)) words.push_back(word_of(option, one));
  if (option.get_delimiter() == '\0' || words.empty()) return words;
  return {fmt::format("{}", fmt::join(words, std::string(1, option.get_delimiter())))};
}

void add(Words& all, const std::string& name, const Words& words) {
  if (!name.empty()) all.push_back(name);
  all.insert(all.end(), words.begin(), words.end());
}

void add_list(const CLI::Option& option, const std::string& name, const py::handle& value, Words& all) {
  const py::list list(py::reinterpret_borrow<py::object>(value));
  if (list.empty()) refuse(option, "some values, or None", value);
  if (takes_lists(option) && is_list(list[0])) {
    for (const py::handle& run : list) {
      if (!is_list(run)) refuse(option, "one list for each run", value);
      add(all, name, words_of_list(option, run));
    }
  } else if (!takes_lists(option) && !option.get_allow_extra_args() && option.get_items_expected_min() == 1) {
    for (const py::handle& one : list) add(all, name, {word_of(option, one)});  // --out A --out B
  } else {
    add(all, name, words_of_list(option, list));
  }
}

void add_option(const CLI::Option& option, const py::handle& value, Words& all) {
  const std::string name = option.get_positional() ? "" : "--" + option.get_lnames().front();
  if (is_flag(option)) {
    if (!py::isinstance<py::bool_>(value)) refuse(option, "True or False", value);
    if (value.cast<bool>()) all.push_back(name);
  } else if (is_list(value)) {
    if (!takes_many(option)) refuse(option, "one value", value);
    add_list(option, name, value, all);
  } else {
    add(all, name, {word_of(option, value)});
  }
}

const CLI::Option& option_of(const std::vector<const CLI::Option*>& options, const std::string& verb,
                             const std::string& keyword) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    names.push_back(keyword_of(*option));
    if (names.back() == keyword) return *option;
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw py::type_error(
      fmt::format("{}(): no such keyword; got {}", verb, in_quotes_with_guess(keyword, known)));
}

// For the type hints.
std::string type_of(const CLI::Option& option) {
  if (is_flag(option)) return "bool";
  const std::string given = option.get_type_name();
  const bool is_whole = given.find("INT") != std::string::npos;
  std::string one = given.find("FLOAT") != std::string::npos ? "float" : is_whole ? "int" : "Text";
  if (!takes_many(option)) return one;
  if (takes_lists(option)) return fmt::format("{0} | Sequence[{0}] | Sequence[Sequence[{0}]]", one);
  const bool fixed = option.get_items_expected_min() > 1;
  return fixed ? fmt::format("Sequence[{}]", one) : fmt::format("{0} | Sequence[{0}]", one);
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  std::vector<const CLI::Option*> options = app.get_options();
  std::erase(options, app.get_help_ptr());
  return options;
}

}  // namespace

void set_options(CLI::App& app, const std::string& verb, const py::dict& keywords) {
  app.set_help_flag();  // `help(mikromakro.average)`
  check_values(app);
  const std::vector<const CLI::Option*> options = options_of(app);
  Words positional, words;
  for (const auto& [key, value] : keywords) {
    const auto keyword = key.cast<std::string>();
    const CLI::Option& option = option_of(options, verb, keyword);
    if (!value.is_none()) add_option(option, value, option.get_positional() ? positional : words);
  }
  for (std::string& file : positional)  // which may have the name of an option
    if (file.starts_with("-")) file.insert(0, "./");
  words.insert(words.begin(), positional.begin(), positional.end());
  check_lists(app, words);
  std::reverse(words.begin(), words.end());
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    throw Error(Error::Kind::bad_input,
                complaint(app, error, fmt::format("what `help(mikromakro.{})` lists", verb)));
  }
}

py::list describe_options(const CLI::App& app) {
  py::list all;
  for (const CLI::Option* option : options_of(app))
    all.append(py::make_tuple(keyword_of(*option), type_of(*option), option->get_description()));
  return all;
}

}  // namespace mikromakro
