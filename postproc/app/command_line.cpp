// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "model/nearest_name.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

bool is_number(const std::string& word) {
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

// The parser recognises a negative number only if a digit follows the sign.
std::string as_value(std::string word) {
  const bool negative = word.starts_with('-') && is_number(word);
  if (negative && word[1] == '.') word.insert(1, "0");
  return word;
}

std::string of_verb(const CLI::App& program) {
  std::vector<std::string> storage;
  for (const CLI::App* verb : program.get_subcommands({})) storage.push_back(verb->get_name());
  const std::vector<std::string_view> verbs(storage.begin(), storage.end());
  const std::vector<std::string> given = program.remaining();
  return fmt::format("command line: {}; expected one of {}, got {}",
                     given.empty() ? "no verb" : "unknown verb", fmt::join(verbs, ", "),
                     given.empty() ? "none" : in_quotes_with_guess(given.front(), verbs));
}

}  // namespace

std::vector<std::string> words_for_parser(const CLI::App& program, int argc, char** argv) {
  std::vector<std::string> words(std::next(argv), std::next(argv, argc));
  for (const CLI::App* verb : program.get_subcommands({}))
    if (!words.empty() && verb->get_name() == words.front()) check_lists(*verb, words);
  std::transform(words.begin(), words.end(), words.begin(), as_value);
  std::reverse(words.begin(), words.end());
  return words;
}

std::string complaint_of(const CLI::App& program, const CLI::ParseError& error) {
  const auto parsed = program.get_subcommands();
  if (parsed.empty()) return of_verb(program);
  const CLI::App& verb = *parsed.front();
  return complaint(verb, error, fmt::format("options as listed by `mikromakro {} --help`", verb.get_name()));
}

}  // namespace mikromakro
