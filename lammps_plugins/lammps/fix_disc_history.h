// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's contact history fix, with a bug worked around.
#pragma once

#include <cstdio>

#include "comm.h"
#include "fix_neigh_history.h"

namespace mikromakro::styles {

/// Style NEIGH_HISTORY/DISC, made by the pair style only.
///
/// For restart files the engine copies springs from the pairs of the last neighbour list to the atoms. This
/// is correct within a run, but the command write_restart first migrates atoms between ranks, after which the
/// list refers to other atoms. Between runs the springs are already stored with the atoms.
class FixDiscHistory : public LAMMPS_NS::FixNeighHistory {
 public:
  using FixNeighHistory::FixNeighHistory;
  void post_neighbor() override {
    FixNeighHistory::post_neighbor();
    runs_ = true;
  }
  void post_run() override {
    FixNeighHistory::post_run();
    runs_ = false;
  }
  void write_restart(FILE* file) override {
    if (runs_) {
      FixNeighHistory::write_restart(file);
    } else if (comm->me == 0) {
      constexpr int size = 0;
      std::fwrite(&size, sizeof size, 1, file);
    }
  }

 private:
  bool runs_ = false;
};

}  // namespace mikromakro::styles
