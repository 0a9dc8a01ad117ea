// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/unnamed_variables.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "model/nearest_name.h"

namespace mikromakro::styles {

namespace {

// What follows a '#' outside of quotes is a comment; `quote` (a quotation mark, or three) is open from one
// line to the next.
std::string without_comment(const std::string& line, std::string& quote) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!quote.empty()) {
      if (line.compare(i, quote.size(), quote) != 0) continue;
      i += quote.size() - 1;
      quote.clear();
    } else if (line[i] == '#') {
      return line.substr(0, i);
    } else if (line.compare(i, 3, "\"\"\"") == 0) {
      quote = "\"\"\"";
      i += 2;
    } else if (line[i] == '"' || line[i] == '\'') {
      quote = line.substr(i, 1);
    }
  }
  // Only triple quotes span lines.
  if (quote.size() == 1) quote.clear();
  return line;
}

// Calls `take` with the first group of each match.
template <class Take>
void each(const std::string& text, const std::regex& pattern, Take take) {
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    take((*match)[1].str());
}

// The variables of a script and of those that it leads to.
class Scripts {
 public:
  explicit Scripts(std::map<std::string, std::string> values) : values_(std::move(values)) {}

  /// Whether all files could be read.
  bool read(const std::string& file) {
    if (!files_.insert(file).second) return true;
    std::ifstream script(file);
    if (!script) return false;
    std::string line, quote;
    while (std::getline(script, line)) {
      line = without_comment(line, quote);
      take_variables(line);
      if (!follow(line)) return false;
    }
    return true;
  }

  bool use(const std::string& variable) const { return used_.count(variable) != 0; }
  std::vector<std::string_view> defined() const { return {defined_.begin(), defined_.end()}; }

 private:
  void take_variables(const std::string& line) {
    static const std::regex in_text(R"(\$\{(\w+)\}|\$(\w))"), in_formulas(R"(\bv_(\w+))"),
        definition(R"(\bvariable\s+(\w+))"), next(R"(\bnext((?:\s+\w+)+))"), word(R"((\w+))"),
        value(R"(^\s*variable\s+(\w+)\s+(?:index|string)\s+["']?([^\s"']+))"),
        asked_for(R"(\bis_\w+\(\s*variable\s*,\s*(\w+))");
    const auto use = [this](const std::string& name) { used_.insert(name); };
    for (std::sregex_iterator match(line.begin(), line.end(), in_text), end; match != end; ++match)
      use((*match)[1].matched ? (*match)[1].str() : (*match)[2].str());
    each(line, in_formulas, use);
    each(line, asked_for, use);
    each(line, definition, [&](const std::string& name) {
      use(name);
      defined_.insert(name);
    });
    each(line, next, [&](const std::string& names) { each(names, word, use); });
    // The command line and the first definition win.
    if (std::smatch match; std::regex_search(line, match, value))
      values_.emplace(match[1].str(), match[2].str());
  }

  bool follow(const std::string& line) {
    static const std::regex leads_to(R"(\b(?:include|jump)\s+([^\s"']+))");
    bool all = true;
    each(line, leads_to, [&](const std::string& file) {
      const std::string name = substituted(file);
      all = all && (name == "SELF" || (name.find('$') == std::string::npos && read(name)));
    });
    return all;
  }

  std::string substituted(std::string text) const {
    static const std::regex reference(R"(\$\{(\w+)\})");
    std::smatch match;
    while (std::regex_search(text, match, reference)) {
      const auto value = values_.find(match[1].str());
      if (value == values_.end()) break;
      text = match.prefix().str() + value->second + match.suffix().str();
    }
    return text;
  }

  std::map<std::string, std::string> values_;
  std::set<std::string> files_, used_, defined_;
};

}  // namespace

std::vector<std::string> unnamed_variables(const std::vector<std::string>& arguments) {
  std::string file;
  std::vector<std::string> names, lines;
  std::map<std::string, std::string> values;
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == "-in" || arguments[i] == "-i") file = arguments[i + 1];
    if (arguments[i] != "-var" && arguments[i] != "-v") continue;
    names.push_back(arguments[i + 1]);
    if (i + 2 < arguments.size()) values.emplace(arguments[i + 1], arguments[i + 2]);
  }
  Scripts scripts(std::move(values));
  if (file.empty() || names.empty() || !scripts.read(file)) return {};
  const std::vector<std::string_view> defined = scripts.defined();
  for (const std::string& name : names)
    if (!scripts.use(name))
      lines.push_back("-var: no line of " + file + " uses a variable " + in_quotes_with_guess(name, defined));
  return lines;
}

}  // namespace mikromakro::styles
