// The forces of the last step, with which the next run goes on.
#pragma once

#include <array>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Forces and torques that discs had at the end of a step, for the first half-kick of the run that continues
/// from there, in the same process or from a restart file.
///
/// The set-up of a run evaluates the forces again: dashpots then see the final velocities and not the
/// predicted ones, and a spring that slides is rounded once more. A run that went on with those forces would
/// not be the one that was never interrupted.
class LastForces {
 public:
  explicit LastForces(LAMMPS_NS::LAMMPS& engine) : engine_(engine) {}

  /// Notes the discs of the group as they are at the end of this step.
  void keep(int group_bit);

  /// Gives the noted forces to those discs of the group that are still where they were, as fast as they were.
  void restore(int group_bit) const;

  // Per-atom storage, as the engine asks for it.
  static constexpr int values = 9;
  void grow(int count) { kept_.resize(count); }
  void copy(int from, int to) { kept_[to] = kept_[from]; }
  void forget(int i) { kept_[i] = {}; }
  int pack(int i, double* buffer) const;
  int unpack(int i, const double* buffer);
  double memory_usage() const { return static_cast<double>(kept_.size() * sizeof(Kept)); }

 private:
  struct Kept {
    double valid = 0;
    std::array<double, 2> x{};
    std::array<double, 3> motion{}, load{};  // v_x, v_y, omega; f_x, f_y, torque
  };
  bool unchanged(int i) const;

  LAMMPS_NS::LAMMPS& engine_;
  std::vector<Kept> kept_;  // of each owned atom
};

}  // namespace mikromakro::styles
