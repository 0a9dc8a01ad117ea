// SPDX-License-Identifier: GPL-2.0-or-later
// mikromakro: continuum fields from discs and contacts.
#include <fmt/format.h>
#include <malloc.h>

#include <cerrno>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/interrupts.h"
#include "averaging/parallel/ranks.h"
#include "io/hdf5/hdf5_file.h"
#include "model/error.h"
#include "options/value_checks.h"

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

// Limits messages that do not come from the library, such as a failed allocation.
constexpr std::size_t longest_message = 2500;

// All ranks agree on an error, and rank 0 prints it and returns the code: mpirun would cut the message short
// if another rank exited with one.
int complain(const std::string& message, int code) {
  if (mikromakro::launched_rank() > 0) return exit_done;
  fmt::print(stderr, "mikromakro: {}\n", mikromakro::one_line(message, longest_message));
  return code;
}

// Buffered output may reach a full disk only here.
int finish(int code) {
  std::cout.flush();
  const bool written = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (written || code != exit_done) return code;
  const std::string reason = std::strerror(errno);
  return complain("standard output: cannot write the output; expected space on the disk, got " + reason,
                  exit_failed);
}

// Under mpirun, verbs that are not parallel run on rank 0 only.
bool idle(int argc, char** argv) {
  if (mikromakro::launched_rank() == 0) return false;
  const std::string verb = argc < 2 ? "" : argv[1];
  return verb != "average" && verb != "compare";
}

int run(int argc, char** argv) {
  if (idle(argc, argv)) return exit_done;
  CLI::App program("Continuum fields from discs and contacts.", "mikromakro");
  program.set_version_flag("--version", "mikromakro " MIKROMAKRO_VERSION);
  program.require_subcommand(1);
  mikromakro::add_average_command(program);
  mikromakro::add_compare_command(program);
  mikromakro::add_info_command(program);
  mikromakro::add_fit_command(program);
  mikromakro::add_audit_command(program);
  mikromakro::add_convert_command(program);
  mikromakro::add_draw_command(program);
  mikromakro::add_report_command(program);
  mikromakro::add_timestep_command(program);
  for (CLI::App* verb : program.get_subcommands({})) mikromakro::check_values(*verb);
  try {
    program.parse(mikromakro::words_for_parser(program, argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
    return complain(mikromakro::complaint_of(program, error), exit_bad_input);
  }
  return exit_done;
}

// Keep freed memory in the process for the next frame: memory returned to the system is cleared page by page
// on each new request, which costs a tenth of the reading time.
void keep_memory() {
  constexpr int largest = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, largest);
}

int run_and_tell(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const mikromakro::Error& error) {
    return complain(error.what(),
                    error.kind() == mikromakro::Error::Kind::run_failed ? exit_failed : exit_bad_input);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  mikromakro::prepare_for_interrupts();
  mikromakro::leave_hdf5_open_at_exit();
  return finish(run_and_tell(argc, argv));
}
