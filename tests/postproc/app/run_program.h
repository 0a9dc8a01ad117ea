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

/// `mikromakro ARGUMENTS` in the given folder, arguments as a shell takes them.
inline Ran run_program(const std::string& arguments, const std::string& folder = TEST_DATA) {
  const Folder outputs;
  const std::string command = "cd '" + folder + "' && '" MIKROMAKRO_PROGRAM "' " + arguments + " >'" +
                              outputs.path("out") + "' 2>'" + outputs.path("err") + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(outputs.path("out")),
          read_text(outputs.path("err"))};
}

}  // namespace mikromakro
