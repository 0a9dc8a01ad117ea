// liggghts-disc: the packaged LIGGGHTS with the disc styles; same command line as liggghts.
#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "input.h"
#include "lammps.h"
#include "registration.h"
#include "signal_handling.h"

namespace {

// As in the engine's own program: SIGINT and SIGTERM end the run after the current step and write what is
// due, SIGUSR1 asks for a restart file. mpirun turns a SIGINT into a SIGTERM to its children.
void install_signal_handlers() {
  struct sigaction end_run {};
  end_run.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigaction(SIGINT, &end_run, nullptr);
  sigaction(SIGTERM, &end_run, nullptr);
  struct sigaction write_now {};
  write_now.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &write_now, nullptr);
}

bool wants_help(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "-help" || argument == "-h") return true;
  }
  return false;
}

/// The engine exits with 1 after its help.
void end_of_help() {
  std::fflush(nullptr);
  std::_Exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  // Line by line also into a pipe: an error of one rank ends the others, and what they hold back is lost.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  install_signal_handlers();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::printf("%s\n", mikromakro::liggghts::version_line());
    // The engine prints its own help and ends inside its constructor, so ours comes first.
    if (wants_help(argc, argv)) std::printf("%s", mikromakro::liggghts::style_list().c_str());
  }
  if (wants_help(argc, argv)) std::atexit(end_of_help);
  {
    const auto engine = std::make_unique<LAMMPS_NS::LAMMPS>(argc, argv, MPI_COMM_WORLD);
    mikromakro::liggghts::register_styles(*engine);
    engine->input->file();
  }
  MPI_Finalize();
  return 0;
}
