// SPDX-License-Identifier: GPL-2.0-or-later
// fix bottom/friction: friction between discs and the bottom of the cell.
#pragma once

#include <cstdio>

#include "dialect.h"
#include "law/fix_on_rows.h"

namespace mikromakro::styles {

class DiscLaw;

/// fix ID group bottom/friction MU_B G [velocity V0]
///
/// Force -mu_b m g v/|v| on each disc of the group, -mu_b m g v/V0 below V0
/// (physics/walls/bottom_friction.h), at the velocities used for contacts in the same step. mu_b [-] and the
/// gravitational acceleration G [m/s^2] are positive; V0 [m/s] is at least 2 mu_b G dt and defaults to 10
/// mu_b G dt. Spins are not affected. A disc under a force below mu_b m g creeps at less than V0.
///
/// Scalar: energy dissipated by the bottom since the fix was defined [J], kept in restart files. Vector: 1
/// the current dissipated power [W].
class FixBottomFriction : public FixOfEngine, public FixOnRows {
 public:
  FixBottomFriction(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);

  int setmask() override;
  int calls_on_rows() const override { return LAMMPS_NS::FixConst::POST_FORCE; }
  void init() override;
  void setup(int vflag) override;
  void post_force(int vflag) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

 private:
  double apply();  // returns the power of this rank's discs
  double sum_of_all_ranks(double value) const;

  DiscLaw* law_ = nullptr;
  double mu_b_, g_;
  double given_v_0_ = 0;  // 0: not given
  double v_0_ = 0;
  // For the discs of this rank: power at the last evaluation [W], energy dissipated [J].
  double power_ = 0, energy_ = 0;
  bool continues_ = false;  // power_ was kept from the last step
};

}  // namespace mikromakro::styles
