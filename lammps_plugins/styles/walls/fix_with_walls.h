// SPDX-License-Identifier: GPL-2.0-or-later
// Base class of fixes with smooth walls: springs at walls migrate with the atoms and are kept in restart
// files.
#pragma once

#include <vector>

#include "dialect.h"
#include "walls/smooth_walls.h"
#include "walls/walls_of_restart.h"

namespace mikromakro::styles {

class FixWithWalls : public FixWithClock, public WallContactSource {
 public:
  ~FixWithWalls() override;
  FixWithWalls(const FixWithWalls&) = delete;
  FixWithWalls& operator=(const FixWithWalls&) = delete;

  double memory_usage() override { return walls_.springs().memory_usage(); }
  void grow_arrays(int nmax) override { walls_.springs().grow(nmax); }
  void copy_arrays(int from, int to, int /*delflag*/) override { walls_.springs().copy(from, to); }
  void set_arrays(int i) override { walls_.springs().clear(i); }
  int pack_exchange(int i, double* buffer) override { return walls_.springs().pack(i, buffer); }
  int unpack_exchange(int i, double* buffer) override { return walls_.springs().unpack(i, buffer); }

  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int i) override { return 1 + walls_.springs().packed_size(i); }
  int maxsize_restart() override { return 1 + walls_.springs().largest_packed_size(); }

  bool append_wall_contacts(int group_bit, std::vector<ContactRow>& rows) const override {
    return walls_.append_contacts(group_bit, rows);
  }
  std::vector<WallKind> wall_kinds() const override { return walls_.kinds(); }
  std::vector<WallTouch> touches() const override { return walls_.touches(); }

 protected:
  /// Stops the run in three dimensions, or if atoms have no spin.
  FixWithWalls(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);
  /// Call once the walls have been added.
  void store_springs_with_atoms();

  SmoothWalls walls_;
  WallsOfRestart saved_walls_;

 private:
  bool springs_are_kept_ = false;
};

}  // namespace mikromakro::styles
