// SPDX-License-Identifier: GPL-2.0-or-later
// The forces of the last step, with which the next run goes on.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "physics/disc_rows.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Forces and torques that discs had at the end of a step, and the velocities that these forces depended on,
/// for the first half-kick of the run that continues from there, in the same process or from a restart file.
///
/// The set-up of a run evaluates forces anew. Where no disc has changed since, contacts see the velocities of
/// the last evaluation once more, and so the same forces result, but for the rounding of a spring that
/// slides. A disc whose force is the same in this sense goes on with the last bits of it, so that the run is
/// the one that was never interrupted. Whatever else has changed, a constant, a neighbour or a fix of any
/// kind, shows in the force itself, and then the new one counts, as in stock engines.
class LastForces {
 public:
  explicit LastForces(LAMMPS_NS::LAMMPS& engine) : engine_(engine) {}

  /// Notes the velocities that forces depended on: those in the rows of the owned discs; spins are those of
  /// the engine where a law without friction has left them out of the rows.
  void see(const physics::DiscRow* rows, bool rows_have_spins);
  /// Notes the discs as they are at the end of this step. After see().
  void keep();

  /// Whether every disc of all ranks is as it was when it was kept, and none is missing or new.
  bool nothing_changed() const;
  const std::array<double, 3>& seen(int i) const { return kept_[i].seen; }

  /// Gives the noted forces to those discs of the group that have the same ones to rounding. contact_force:
  /// of the strongest contacts [N], for their rounding.
  void restore(int group_bit, double contact_force) const;

  // Per-atom storage, as the engine asks for it.
  static constexpr int values = 14;
  void grow(int count) { kept_.resize(count); }
  void copy(int from, int to) { kept_[to] = kept_[from]; }
  void forget(int i) { kept_[i] = {}; }
  int pack(int i, double* buffer) const;
  int unpack(int i, const double* buffer);
  double memory_usage() const { return static_cast<double>(kept_.size() * sizeof(Kept)); }

 private:
  struct Kept {
    double discs = 0;                // in the whole system; 0: nothing is known
    std::array<double, 4> shape{};   // x, y, radius, type
    std::array<double, 3> motion{};  // v_x, v_y, omega
    std::array<double, 3> seen{};    // the same when forces were evaluated
    std::array<double, 3> load{};    // f_x, f_y, torque
  };
  static_assert(sizeof(Kept) == values * sizeof(double));
  bool unchanged(int i) const;

  LAMMPS_NS::LAMMPS& engine_;
  std::vector<Kept> kept_;  // of each owned atom
};

}  // namespace mikromakro::styles
