// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group wall/disc type T plane NX NY OFFSET         [move vx VX vy VY]
// fix ID group wall/disc type T circle X Y R inside/outside [move vx VX vy VY] [rotate OMEGA]
//
// A smooth wall in contact with the discs of the group under the law of the pair style
// (physics/walls/smooth_wall.h), with the material constants of the atom type T: frictionless if its constant
// mu with the types of the discs is 0.
//
//   plane   the straight line at the distance OFFSET (m, may be negative) from the origin along (NX, NY), a
//           vector of any length that points from the wall to the discs: 'plane 0 1 0' is the floor y = 0
//   circle  of radius R about (X, Y) (m), with the discs inside or outside
//   move    at the velocity VX, VY (m/s; default 0). A plane that moves along itself is a belt
//   rotate  the surface rotates at OMEGA about its centre (1/s, counter-clockwise positive)
//
// Walls have no periodic images: a plane whose normal has a component along a periodic direction, or a circle
// that a disc can touch from the other side, is rejected.
//
// The ids in contact rows are id2 = -11, -12, ... in the order of the fixes. A fix that continues from a
// restart file continues from the wall's stored position; one with a different geometry starts afresh.
//
// Scalar: work of the wall on the discs (J), since the fix was defined, continued across restarts. Vector,
// of the last force evaluation:
//   1, 2  force of the discs on the wall, N       3  their torque on it about the circle's centre (plane: the
//                                                    origin), N m; counter-clockwise positive
//   4     the scalar, J                            5  sum of the normal forces, N; positive in compression
#pragma once

#include <array>

#include "law/fix_on_rows.h"
#include "physics/motion/step_clock.h"
#include "walls/fix_with_walls.h"
#include "walls/wall_disc_settings.h"

namespace mikromakro::styles {

class FixWallDisc : public FixWithWalls, public FixOnRows {
 public:
  FixWallDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);

  void init() override;
  void setup(int vflag) override;
  void post_force(int vflag) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int i) override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  int calls_on_rows() const override { return LAMMPS_NS::FixConst::POST_FORCE; }

 protected:
  int calls_wanted() const override { return LAMMPS_NS::FixConst::POST_FORCE; }
  void once_defined() override;
  void renumber_steps(LAMMPS_NS::bigint shift) override;

 private:
  [[nodiscard]] physics::SmoothWall wall_at(LAMMPS_NS::bigint step) const;
  void follow_time_step(LAMMPS_NS::bigint step);
  void check_periodic_images(const physics::SmoothWall& wall) const;
  void warn_outside_box(const physics::SmoothWall& wall) const;
  [[nodiscard]] double apply();  // returns the power of this rank's discs (W)
  [[nodiscard]] double sum_of_all_ranks(double value) const;
  const std::array<double, 4>& loads();

  WallDiscSettings settings_;
  physics::PlaneVector start_;  // the wall's point at start_time_ (m, s)
  double start_time_ = 0;
  physics::StepClock clock_;
  double largest_radius_ = 0;  // in the group, at the start of a run (m)
  // For the discs of this rank: power of the wall on them at the last evaluation (W), its work (J).
  double power_ = 0, work_ = 0;
  bool continues_ = false;  // power_ was kept from the last step
  std::array<double, 4> loads_{};
  LAMMPS_NS::bigint step_of_loads_ = -1;
};

}  // namespace mikromakro::styles
