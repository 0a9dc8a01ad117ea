// mikromakro: continuum fields from discs and contacts.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/commands.h"
#include "averaging/ranks.h"
#include "io/error.h"

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

// Ranks agree on an error, and rank 0 tells it: mpirun would cut it short if another one ended with its code.
int complain(std::string message, int code) {
  if (mikromakro::launched_rank() > 0) return exit_done;
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "mikromakro: {}\n", message);
  return code;
}

// Under mpirun only rank 0 does what cannot be shared out.
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
  mikromakro::add_timestep_command(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::string given = mikromakro::in_quotes(fmt::format("{}", fmt::join(arguments, " ")));
    return complain(
        fmt::format("command line: {}; expected what `mikromakro --help` lists, got {}", error.what(), given),
        exit_bad_input);
  }
  return exit_done;
}

}  // namespace

// The memory of a frame is used again for the next one; given back to the system and asked for anew, it would
// be cleared page by page each time, a tenth of the time that reading takes.
void keep_memory() {
  constexpr int largest = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, largest);
}

int main(int argc, char** argv) {
  keep_memory();
  try {
    return run(argc, argv);
  } catch (const mikromakro::Error& error) {
    return complain(error.what(),
                    error.kind() == mikromakro::Error::Kind::run_failed ? exit_failed : exit_bad_input);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failed);
  }
}
