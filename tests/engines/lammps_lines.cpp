// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of LIGGGHTS as LAMMPS spells them. Constants become coefficients of pairs of types.
#include <sstream>

#include "engine_lines.h"

namespace mikromakro::test {

namespace {

const std::map<std::string, std::string> keywords = {{"kn", "kn"},
                                                     {"gamman_abs", "gamman"},
                                                     {"kt", "kt"},
                                                     {"gammat_abs", "gammat"},
                                                     {"coefficientFriction", "mu"}};

using Words = std::vector<std::string>;

/// Words of a line; what is in quotes stays together.
Words words_of(const std::string& line) {
  Words words;
  std::string word;
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') quoted = !quoted;
    if ((letter == ' ' || letter == '\t') && !quoted) {
      if (!word.empty()) words.push_back(word);
      word.clear();
    } else {
      word += letter;
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

std::string joined(const Words& words) {
  std::string line;
  for (const auto& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// pair_style gran model NAME tangential ... -> pair_style NAME tangential ...
std::string law(const Words& words) {
  Words own = {"pair_style"};
  for (std::size_t k = 3; k < words.size(); ++k) {
    if (words[k] == "absolute_damping") {
      ++k;
    } else {
      own.push_back(words[k]);
    }
  }
  return joined(own);
}

/// What error lines call a law; comments may say which are expected.
std::string comment(std::string line) {
  const std::string name = "pair_style gran model disc/";
  const auto place = line.find(name);
  if (place != std::string::npos) line.replace(place, name.size(), "pair_style disc/");
  return line;
}

/// Densities are areal ones, spins have three components.
std::string set_command(Words words) {
  for (auto& word : words) {
    if (word == "density") word = "density/disc";
    if (word == "omegaz") word = "omega 0 0";
  }
  return joined(words);
}

std::string dump_format(Words words) {
  for (auto& word : words)
    if (word == "format") word = "format line";
  return joined(words);
}

}  // namespace

std::vector<std::string> EngineLines::coefficients() const {
  std::vector<std::string> lines;
  const int types = constants_.empty() ? 0 : constants_.begin()->second.types;
  for (int i = 1; i <= types; ++i) {
    for (int j = i; j <= types; ++j) {
      std::string line = "pair_coeff " + std::to_string(i) + " " + std::to_string(j);
      for (const auto& [id, constant] : constants_)
        line += " " + constant.keyword + " " + constant.values.at((i - 1) * types + j - 1);
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<std::string> EngineLines::of(const std::string& line) {
  const Words words = words_of(line);
  if (words.empty()) return {};
  const auto& command = words[0];
  const auto starts = [&](const Words& first) {
    return words.size() >= first.size() && Words(words.begin(), words.begin() + first.size()) == first;
  };
  if (command == "#") return {comment(line)};
  if (command == "clear") {
    *this = {};
  } else if (starts({"atom_style", "granular"})) {
    return {"atom_style sphere"};
  } else if (starts({"communicate", "single"})) {
    return {"comm_modify mode single vel yes"};
  } else if (command == "fix" && words.size() > 6 && words[3] == "property/global") {
    constants_[words[1]] = {keywords.at(words[4]), std::stoi(words[6]), {words.begin() + 7, words.end()}};
    return coefficients_due_ ? coefficients() : Words{};
  } else if (command == "unfix" && constants_.erase(words[1]) > 0) {
    return {};
  } else if (starts({"pair_style", "gran", "model"}) && words[3].starts_with("disc/")) {
    law_defined_ = true;
    return {law(words)};
  } else if (starts({"pair_coeff", "*", "*"}) && law_defined_) {
    // Scripts of LIGGGHTS may give constants later.
    coefficients_due_ = true;
    return coefficients();
  } else if (command == "read_restart") {
    // Of its count of degrees of freedom, which a single disc would make negative, the engine knows only from
    // the command `dimension` that it is in the plane.
    return {line, "compute_modify thermo_temp extra/dof 2"};
  } else if (command == "set") {
    return {set_command(words)};
  } else if (command == "dump_modify") {
    return {dump_format(words)};
  } else if (command == "fix" && words.size() == 4 && words[3] == "nve/sphere") {
    return {line + " disc"};
  }
  return {line};
}

}  // namespace mikromakro::test
