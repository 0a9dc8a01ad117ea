// SPDX-License-Identifier: GPL-2.0-or-later
// script_of_engine SCRIPT: prints a script of LIGGGHTS, with what it includes, in the lines of the engine
// that this program was built for.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "engine_lines.h"

namespace {

std::string with_includes(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("expected a script, got nothing at " + path.string());
  std::string script;
  for (std::string line; std::getline(file, line);) {
    const std::string command = "include";
    const bool includes = line.starts_with(command + " ");
    const auto name = includes ? line.find_first_not_of(' ', command.size()) : 0;
    script += includes ? with_includes(path.parent_path() / line.substr(name)) : line + "\n";
  }
  return script;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("expected one argument, SCRIPT");
    std::cout << mikromakro::test::lines_of_engine(with_includes(argv[1]));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "script_of_engine: " << error.what() << '\n';
    return 1;
  }
}
