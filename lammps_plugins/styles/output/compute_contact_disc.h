// SPDX-License-Identifier: GPL-2.0-or-later
// compute contact/disc: one row per contact, with the forces applied in this step.
#pragma once

#include <vector>

#include "dialect.h"
#include "law/contact_rows.h"

namespace mikromakro::styles {

/// compute ID group contact/disc
///
/// Local rows with the columns of contact_rows.h, including contacts with walls. Both discs must be in the
/// group. Nothing is re-evaluated: the rows hold the forces that pair style and walls applied.
class ComputeContactDisc : public ComputeOfEngine {
 public:
  ComputeContactDisc(LAMMPS_NS::LAMMPS* engine, int& iarg, int narg, char** arg);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  std::vector<ContactRow> rows_;
  std::vector<double*> row_pointers_;  // array_local expects row pointers
};

}  // namespace mikromakro::styles
