// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/abort_run.h"

#include <mpi.h>

#include <cstdio>
#include <cstdlib>

#include "lammps.h"

namespace mikromakro::styles {

void abort_run(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what) {
  const std::string text = "ERROR: " + style + ": " + what + "\n";
  if (engine.logfile) std::fputs(text.c_str(), engine.logfile);
  std::fflush(nullptr);
  std::fputs(text.c_str(), stderr);
  MPI_Abort(engine.world, 1);
  std::abort();
}

}  // namespace mikromakro::styles
