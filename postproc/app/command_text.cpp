// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/command_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace mikromakro {
namespace {

bool is_plain(unsigned char letter) {
  return std::isalnum(letter) != 0 ||
         std::string_view("_./:,=+-@%").find(static_cast<char>(letter)) != std::string_view::npos;
}

// The words of one option. Between the lists of an option that was given again, the parser puts a separator.
std::string words_of(const CLI::Option& option) {
  const bool positional = option.get_positional() && !option.nonpositional();
  std::string name = positional ? "" : " " + option.get_name();
  if (option.get_items_expected_max() == 0) return name;
  const std::vector<std::string>& values = option.results();
  if (option.get_delimiter() != '\0')
    return name + " " +
           shell_word(fmt::format("{}", fmt::join(values, std::string(1, option.get_delimiter()))));
  std::string words;
  bool begins = true;
  for (const std::string& value : values) {
    const bool separator = value.empty() || value == "%%";
    if (!separator) words += (begins ? name : "") + " " + shell_word(value);
    begins = separator;
  }
  return words;
}

}  // namespace

std::string shell_word(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string given_options(const CLI::App& app, const std::function<bool(std::string_view)>& wanted) {
  std::string words;
  for (const CLI::Option* option : app.get_options([](const CLI::Option* one) { return one->count() > 0; }))
    if (wanted(option->get_name())) words += words_of(*option);
  return words;
}

}  // namespace mikromakro
