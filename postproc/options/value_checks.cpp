// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/value_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "model/error.h"
#include "model/nearest_name.h"

namespace mikromakro {
namespace {

std::string unless(bool good, std::string_view what, std::string_view expected, std::string_view got) {
  return good ? "" : fmt::format("{}; expected {}, got {}", what, expected, in_quotes(got));
}

std::optional<double> number_of(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return value;
}

CLI::Validator number(bool (*good)(double), std::string_view expected, const std::string& name) {
  return {[good, expected](std::string& text) {
            const std::optional<double> value = number_of(text);
            if (!value) return unless(false, "not a number", expected, text);
            return unless(std::isfinite(*value) && good(*value), "invalid value", expected, text);
          },
          name};
}

// Decimal digits with an optional sign, and nothing else.
std::optional<std::int64_t> whole_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Catches scripts with an unset variable.
CLI::Validator not_empty() {
  return {[](std::string& text) {
            return unless(!text.empty(), "an empty value", "a value, or omit the option", text);
          },
          ""};
}

bool takes(const CLI::Option& option, std::string_view kind) {
  return option.get_type_name().find(kind) != std::string::npos;
}

std::vector<std::string_view> option_names(const CLI::App& app, std::vector<std::string>& storage) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) storage.push_back("--" + name);
  return {storage.begin(), storage.end()};
}

std::string of_extra_word(const CLI::App& app, const std::string& word, std::string_view listed) {
  std::vector<std::string> names;
  const bool is_option = word.starts_with('-');
  return fmt::format("{}; expected {}, got {}", is_option ? "unknown option" : "unexpected argument", listed,
                     is_option ? in_quotes_with_guess(word, option_names(app, names)) : in_quotes(word));
}

// The option at the beginning of a parser message.
const CLI::Option* named_in(const CLI::App& app, const std::string& message) {
  return app.get_option_no_throw(message.substr(0, message.find_first_of(": ")));
}

std::string of_value_count(const CLI::Option& option) {
  const int least = option.get_items_expected_min();
  return fmt::format("{}: wrong number of values; expected {}{}, got {}", option.get_name(),
                     option.get_items_expected_max() > least ? "at least " : "", least,
                     option.results().size());
}

}  // namespace

CLI::Validator positive() {
  return number([](double value) { return value > 0; }, "a finite number > 0", "> 0");
}

CLI::Validator not_negative() {
  return number([](double value) { return value >= 0; }, "a finite number >= 0", ">= 0");
}

CLI::Validator whole_number(std::int64_t low, std::int64_t high) {
  const std::string expected = fmt::format("a whole number, {} to {}", low, high);
  return {[=](std::string& text) {
            const std::optional<std::int64_t> value = whole_of(text);
            if (value) text = fmt::format("{}", *value);  // without leading zeros
            return unless(value && *value >= low && *value <= high, "invalid value", expected, text);
          },
          fmt::format("{} to {}", low, high)};
}

CLI::Validator one_of(std::vector<std::string_view> names) {
  return {[names](std::string& text) {
            if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
            return fmt::format("unknown word; expected one of {}, got {}", fmt::join(names, ", "),
                               in_quotes_with_guess(text, names));
          },
          fmt::format("{}", fmt::join(names, "/"))};
}

void check_values(CLI::App& app) {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  for (CLI::Option* option : app.get_options()) {
    if (takes(*option, "FLOAT")) {
      option->check(number([](double) { return true; }, "a finite number", ""));
    } else if (takes(*option, " to ")) {
      continue;  // a whole_number()
    } else if (takes(*option, "UINT") || takes(*option, "INT")) {
      option->transform(whole_number(-most, most).description(""));
    } else if (option->get_items_expected_max() > 0 && !option->get_inject_separator()) {
      option->check(not_empty());
    }
  }
}

void check_lists(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::Option* option = nullptr;
  for (const std::string& word : words) {
    const std::size_t sign = word.starts_with("--") ? word.find('=') : std::string::npos;
    if (const CLI::Option* named = app.get_option_no_throw(word.substr(0, sign))) option = named;
    if (option == nullptr || option->get_delimiter() == '\0') continue;
    const std::string list = ',' + (sign == std::string::npos ? word : word.substr(sign + 1)) + ',';
    if (list != ",," && list.find(",,") != std::string::npos)
      throw bad_input({option->get_name()}, "an empty item in the list", "something between commas",
                      in_quotes(word));
  }
}

std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::string_view listed) {
  std::string message = error.what();
  if (error.get_name() == "ValidationError") return message;
  const CLI::Option* option = named_in(app, message);
  if (error.get_name() == "ArgumentMismatch" && option != nullptr) return of_value_count(*option);
  if (!app.remaining().empty())
    return fmt::format("command line: {}", of_extra_word(app, app.remaining().front(), listed));
  return fmt::format("command line: {}; expected {}, got {}", message, listed,
                     error.get_name() == "ExcludesError" ? "both" : "none");
}

}  // namespace mikromakro
