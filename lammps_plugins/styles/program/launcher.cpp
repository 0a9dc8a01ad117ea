// SPDX-License-Identifier: GPL-2.0-or-later
// liggghts-disc and lmp-disc: the packaged engine with the disc styles; same command line as the engine.
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "engine/engine_access.h"
#include "input.h"
#include "lammps.h"
#include "program/registration.h"
#include "program/unnamed_variables.h"

namespace {

/// Replaces the usual help options by the engine's own.
bool wants_help(int argc, char** argv) {
  static char own[] = "-help";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--help") argv[i] = own;
    if (argument == "--help" || argument == "-help" || argument == "-h") return true;
  }
  return false;
}

/// LIGGGHTS exits with status 1 after its help.
void end_of_help() {
  std::fflush(nullptr);
  std::_Exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  // Line-buffered even into a pipe: an error on one rank aborts the others, whose buffered output would be
  // lost.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  if (argc == 2 && std::string_view(argv[1]) == "--version") {
    std::printf("%s\n", mikromakro::styles::version_line().c_str());
    return 0;
  }
  const bool help = wants_help(argc, argv);
  mikromakro::styles::handle_signals();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::printf("%s\n", mikromakro::styles::version_line().c_str());
    // The engine prints its help and exits in its constructor, so ours is printed first.
    if (help) std::printf("%s", mikromakro::styles::style_list().c_str());
    for (const std::string& line : mikromakro::styles::unnamed_variables({argv + 1, argv + argc}))
      std::fprintf(stderr, "WARNING: %s\n", line.c_str());
  }
  if (help) std::atexit(end_of_help);
  const int code = mikromakro::styles::exit_code_of([&] {
    const auto engine = std::make_unique<LAMMPS_NS::LAMMPS>(argc, argv, MPI_COMM_WORLD);
    mikromakro::styles::register_styles(*engine);
    engine->input->file();
  });
  MPI_Finalize();
  return code;
}
