// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/compute_contact_disc.h"

#include <string>

#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

ComputeContactDisc::ComputeContactDisc(LAMMPS* engine, int& iarg, int narg, char** arg)
    : ComputeOfEngine(engine, iarg, narg, arg) {
  if (narg != iarg)
    Arguments(*lmp, "compute contact/disc", narg, arg, iarg).unexpected("no arguments after the style");
  local_flag = 1;
  timeflag = 1;  // fixes announce when they will read
  size_local_cols = contact_columns;
  size_local_rows = 0;
  array_local = nullptr;
}

void ComputeContactDisc::init() {
  if (!active_disc_law(*lmp)) {
    stop(*lmp, "compute contact/disc", std::string("needs '") + disc_pair_style + "' before the run");
  }
}

void ComputeContactDisc::compute_local() {
  invoked_local = update->ntimestep;
  rows_.clear();
  if (!append_contact_rows(*lmp, groupbit, rows_)) {
    stop(*lmp, "compute contact/disc",
         "the forces of step " + std::to_string(update->ntimestep) +
             " were not recorded; expected to be invoked in an output step, or by a fix that announced the "
             "step");
  }
  row_pointers_.clear();
  for (auto& row : rows_) row_pointers_.push_back(row.data());
  array_local = row_pointers_.data();
  size_local_rows = static_cast<int>(rows_.size());
}

double ComputeContactDisc::memory_usage() {
  return static_cast<double>(rows_.capacity() * sizeof(ContactRow));
}

}  // namespace mikromakro::styles
