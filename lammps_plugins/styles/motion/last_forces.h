// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of the last step, with which the next run continues.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "physics/rows/disc_rows.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Forces and torques of the discs at the end of a step, and the velocities they were evaluated with, for the
/// first half-kick of the continued run, in the same process or from a restart file.
///
/// The set-up of a run re-evaluates forces. If no disc has changed since, contacts use the velocities of the
/// last evaluation again, so the forces agree except for rounding in sliding springs. A disc whose force
/// agrees to rounding continues with the exact bits of the old one, so the run equals the uninterrupted one.
/// Any other change, of a constant, a neighbour or a fix, changes the force itself; then the new force
/// counts, as in stock engines.
class LastForces {
 public:
  explicit LastForces(LAMMPS_NS::LAMMPS& engine) : engine_(engine) {}

  /// Stores the velocities used for the forces: those in the rows of the owned discs; for laws without
  /// friction, whose rows lack spins, the engine's spins.
  void store_velocities(const physics::DiscRow* rows, bool rows_have_spins);
  /// Stores the discs as they are at the end of this step. Call after store_velocities().
  void store_discs();

  /// True if every disc on all ranks is unchanged since store_discs(), and none is missing or new.
  bool nothing_changed() const;
  const std::array<double, 3>& velocities(int i) const { return kept_[i].velocities; }

  /// Restores the stored forces on those discs of the group whose present forces agree to rounding.
  /// contact_force: largest contact force [N], which sets the rounding tolerance.
  void restore(int group_bit, double contact_force) const;

  // Per-atom storage, for the engine's callbacks.
  static constexpr int values = 14;
  void grow(int count) { kept_.resize(count); }
  void copy(int from, int to) { kept_[to] = kept_[from]; }
  void forget(int i) { kept_[i] = {}; }
  int pack(int i, double* buffer) const;
  int unpack(int i, const double* buffer);
  double memory_usage() const { return static_cast<double>(kept_.size() * sizeof(Kept)); }

 private:
  struct Kept {
    double discs = 0;                    // in the whole system; 0: nothing stored
    std::array<double, 4> shape{};       // x, y, radius, type
    std::array<double, 3> motion{};      // v_x, v_y, omega
    std::array<double, 3> velocities{};  // the same when forces were evaluated
    std::array<double, 3> load{};        // f_x, f_y, torque
  };
  static_assert(sizeof(Kept) == values * sizeof(double));
  bool unchanged(int i) const;

  LAMMPS_NS::LAMMPS& engine_;
  std::vector<Kept> kept_;  // per owned atom
};

}  // namespace mikromakro::styles
