// SPDX-License-Identifier: GPL-2.0-or-later
// Runs the real program and catches what it says.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "text_file.h"

namespace mikromakro {

struct Ran {
  int code;
  std::string out;
  std::string err;
};

/// `LAUNCHER mikromakro ARGUMENTS` in the given folder, arguments as a shell takes them; a minute at most.
inline Ran launch_program(const std::string& launcher, const std::string& arguments,
                          const std::string& folder) {
  const Folder outputs;
  const std::string command = "cd '" + folder + "' && timeout -k 5 60 " + launcher +
                              " '" MIKROMAKRO_PROGRAM "' " + arguments + " >'" + outputs.path("out") +
                              "' 2>'" + outputs.path("err") + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(outputs.path("out")),
          read_text(outputs.path("err"))};
}

inline Ran run_program(const std::string& arguments, const std::string& folder = TEST_DATA) {
  return launch_program("", arguments, folder);
}

/// The same under mpirun on so many ranks.
inline Ran run_on_ranks(int ranks, const std::string& arguments, const std::string& folder = TEST_DATA) {
  return launch_program(MIKROMAKRO_MPIRUN " -n " + std::to_string(ranks), arguments, folder);
}

}  // namespace mikromakro
