// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/first_rank.h"

#include <mpi.h>

#include <cstdio>
#include <exception>

#include "comm.h"
#include "engine/arguments.h"
#include "error.h"
#include "lammps.h"

namespace mikromakro::styles {

void on_first_rank(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::function<void()>& action) {
  std::string fault;
  if (engine.comm->me == 0) {
    try {
      action();
    } catch (const std::exception& error) {
      fault = error.what();
    }
  }
  int length = static_cast<int>(fault.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, engine.world);
  if (length == 0) return;
  fault.resize(static_cast<std::size_t>(length));
  MPI_Bcast(fault.data(), length, MPI_CHAR, 0, engine.world);
  stop(engine, style, fault);
}

void print_line(LAMMPS_NS::LAMMPS& engine, const std::string& line) {
  if (engine.comm->me != 0) return;
  for (FILE* file : {engine.screen, engine.logfile})
    if (file) std::fprintf(file, "%s\n", line.c_str());
}

void warn(LAMMPS_NS::LAMMPS& engine, const std::string& text) {
  if (engine.comm->me == 0) engine.error->warning(FLERR, text.c_str());
}

}  // namespace mikromakro::styles
