// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/unnamed_variables.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

#include "model/nearest_name.h"

namespace mikromakro::styles {

namespace {

// What follows a '#' outside of quotes is a comment.
std::string without_comment(const std::string& line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && quote == 0) return line.substr(0, i);
    if (line[i] == quote) {
      quote = 0;
    } else if (quote == 0 && (line[i] == '"' || line[i] == '\'')) {
      quote = line[i];
    }
  }
  return line;
}

bool is_of_a_name(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_';
}

// The words of a script and of those that it leads to.
class Scripts {
 public:
  /// Whether all files could be read.
  bool read(const std::string& file) {
    if (!files_.insert(file).second) return true;
    std::ifstream script(file);
    if (!script) return false;
    std::string line;
    while (std::getline(script, line)) {
      line = without_comment(line);
      take_words(line);
      if (!follow(line)) return false;
    }
    return true;
  }

  /// As NAME, v_NAME, ${NAME}, or $N for a name of one letter.
  bool name(const std::string& variable) const {
    return words_.count(variable) != 0 || words_.count("v_" + variable) != 0 ||
           (variable.size() == 1 && dollars_.count(variable.front()) != 0);
  }

  std::vector<std::string_view> defined() const { return {defined_.begin(), defined_.end()}; }

 private:
  void take_words(const std::string& line) {
    for (std::size_t i = 0; i < line.size();) {
      const auto end = static_cast<std::size_t>(
          std::find_if_not(line.begin() + static_cast<std::ptrdiff_t>(i), line.end(), is_of_a_name) -
          line.begin());
      if (end > i) words_.insert(line.substr(i, end - i));
      if (line[i] == '$' && i + 1 < line.size()) dollars_.insert(line[i + 1]);
      i = std::max(end, i + 1);
    }
  }

  bool follow(const std::string& line) {
    std::istringstream words(line);
    std::string command, argument;
    words >> command >> argument;
    if (command == "variable") defined_.insert(argument);
    if ((command != "include" && command != "jump") || argument == "SELF") return true;
    return argument.find('$') == std::string::npos && read(argument);
  }

  std::set<std::string> files_, words_, defined_;
  std::set<char> dollars_;
};

}  // namespace

std::vector<std::string> unnamed_variables(const std::vector<std::string>& arguments) {
  std::string file;
  std::vector<std::string> names, lines;
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == "-in" || arguments[i] == "-i") file = arguments[i + 1];
    if (arguments[i] == "-var" || arguments[i] == "-v") names.push_back(arguments[i + 1]);
  }
  Scripts scripts;
  if (file.empty() || names.empty() || !scripts.read(file)) return {};
  const std::vector<std::string_view> defined = scripts.defined();
  for (const std::string& name : names)
    if (!scripts.name(name))
      lines.push_back("-var: no line of " + file + " uses a variable " + in_quotes_with_guess(name, defined));
  return lines;
}

}  // namespace mikromakro::styles
