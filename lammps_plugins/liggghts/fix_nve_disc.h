// fix nve/disc: velocity Verlet for x, y and the spin about z of discs; what is not in the plane is left
// alone.
#pragma once

#include <vector>

#include "fix.h"

namespace mikromakro::liggghts {

/// fix ID group nve/disc [velocity predicted | half_step]
///
/// m dv/dt = f, I domega/dt = T with I = m a^2 / 2. Forces that depend on velocities are evaluated with the
/// velocities of the same instant as the positions: between the two half-kicks the atoms carry the prediction
/// v(t) + dt f(t)/m, which differs from the final velocity by O(dt^2), and the half-kicked velocity waits in
/// this fix. `velocity half_step` is what the stock integrators do: the dashpot then sees v(t + dt/2), an
/// error of order gamma dt / 2m.
class FixNveDisc : public LAMMPS_NS::Fix {
 public:
  FixNveDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);
  ~FixNveDisc() override;
  FixNveDisc(const FixNveDisc&) = delete;
  FixNveDisc& operator=(const FixNveDisc&) = delete;

  bool predicts_velocities() const { return predicted_; }

  int setmask() override;
  void init() override;
  void initial_integrate(int vflag) override;
  void final_integrate() override;

  void grow_arrays(int nmax) override;
  void copy_arrays(int from, int to, int delflag) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  double memory_usage() override;

 private:
  struct HalfStep {
    double v_x, v_y, omega;
  };
  bool predicted_ = true;
  std::vector<HalfStep> half_step_;  // of each owned atom, between the two half-kicks
};

}  // namespace mikromakro::liggghts
