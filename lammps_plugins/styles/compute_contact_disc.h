// SPDX-License-Identifier: GPL-2.0-or-later
// compute contact/disc: one row for each contact, with the forces that were applied in the step.
#pragma once

#include <vector>

#include "contact_rows.h"
#include "dialect.h"

namespace mikromakro::styles {

/// compute ID group contact/disc
///
/// Local rows with the columns of contact_rows.h, contacts with walls included. Both discs have to be in the
/// group. Nothing is evaluated again: the rows are what pair style and walls applied.
class ComputeContactDisc : public ComputeOfEngine {
 public:
  ComputeContactDisc(LAMMPS_NS::LAMMPS* engine, int& iarg, int narg, char** arg);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  std::vector<ContactRow> rows_;
  std::vector<double*> row_pointers_;  // the engine wants an array of rows
};

}  // namespace mikromakro::styles
