// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group biaxial/2d type T left X CONTROL right X CONTROL bottom Y CONTROL top Y CONTROL [height H]
//
// Four smooth flat walls that form a rectangle around the discs of the group; each moves along its normal
// only. X, Y: initial positions (m). CONTROL is one of
//
//   fixed
//   strain cosine X_END TIME       to X_END (m) within TIME (s) along a half cosine, then fixed
//   strain rate V                  at the velocity V (m/s) along x or y
//   stress P mass M damping G      m x'' = F - P L - G x' outwards (physics/motion/servo_wall.h)
//
// F: force of the discs on the wall (N); L: its length between the adjacent walls (m); P in N/m, or in Pa if
// a height H (m) is given; M in kg, G in kg/s.
//
// type T before the first wall: the atom type that supplies the material constants of the walls; after a
// wall: that of this wall. A wall is frictionless if its constant mu with the types of the discs is 0. All
// walls act under the law of the pair style (physics/walls/smooth_wall.h). Their ids in contact rows are -1,
// -2, -3, -4.
//
// fix_modify ID WALL CONTROL ... [reset]: changes how walls move, from their present positions; a wall whose
// new control is a stress keeps its velocity. reset: strains and work are counted from here on. A fix that
// continues from a restart file takes the walls at their stored positions; if its CONTROL is unchanged, it is
// continued.
//
// For a stress-controlled wall with the half period pi sqrt(M/K) on its contacts of stiffness K, fewer than
// 50 time steps per half period give a warning and fewer than 4 are rejected, at the start and at the end of
// each run.
//
// Scalar: work of all walls on the discs (J). Vector, walls in the order left right bottom top:
//    1 - 4   positions, m                          5 - 8   velocities along x or y, m/s
//    9 - 12  outward normal forces, N             13 - 16  the same per length (and H): N/m or Pa
//   17 - 19  strains: horizontal, vertical (L/L_0 - 1), of the area; negative in compression
//   20 - 23  work on the discs, J                 24 - 27  tangential forces (in x or y), N
#pragma once

#include <array>

#include "law/agreement.h"
#include "law/fix_on_rows.h"
#include "physics/motion/servo_wall.h"
#include "physics/motion/step_clock.h"
#include "walls/biaxial/biaxial_settings.h"
#include "walls/fix_with_walls.h"

namespace mikromakro::styles {

class FixBiaxial2d : public FixWithWalls, public FixOnRows, public KnowsHeight {
 public:
  FixBiaxial2d(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  double given_height() const override { return settings_.height == 1.0 ? 0.0 : settings_.height; }

  void init() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void post_force(int vflag) override;
  void final_integrate() override;
  int modify_param(int narg, char** arg) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int i) override;
  void write_restart(FILE* fp) override;
  void restart(char* buf) override;

  int calls_on_rows() const override {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE;
  }

 protected:
  int calls_wanted() const override;
  void once_defined() override;
  void run_ended() override;
  void renumber_steps(LAMMPS_NS::bigint shift) override;

 private:
  // A moving wall: start of its present control, and work since the last reset.
  struct Wall {
    WallControl control;
    physics::ServoWall motion;  // along x or y
    double contact_velocity;    // for contact forces (m/s)
    double start, start_time;   // m, s
    double pressing, along;     // normal and tangential force at the last evaluation (N)
    double previous_position, previous_pressing;
    double work;  // J
    // The run continues with the acceleration and force of the last step, because dashpots see other
    // velocities in the set-up.
    bool continues = false;
  };

  [[nodiscard]] double length(int axis) const;
  [[nodiscard]] double length_of_wall(int side) const { return length(side < 2 ? 1 : 0); }
  [[nodiscard]] double pressure(int side) const;
  [[nodiscard]] double force_on(int side) const;
  void begin(int side, const WallControl& control);
  void reset_references();
  void follow_time_step(LAMMPS_NS::bigint step);
  void move(Wall& wall, double time) const;
  void check_rectangle() const;
  /// Sums of the stiffness of the contacts of each wall, and of gamma_n of all discs at it [N/m, kg/s].
  struct WallContacts {
    std::array<double, 4> stiffness, damping;
  };
  [[nodiscard]] WallContacts wall_contacts() const;
  void check_time_step() const;
  void check_dashpots(int side, double stable) const;
  [[nodiscard]] std::vector<physics::SmoothWall> smooth_walls() const;
  void sum_forces();

  BiaxialSettings settings_;
  std::array<Wall, 4> box_{};
  std::array<double, 2> reference_lengths_{};  // for strains (m)
  physics::StepClock clock_;
};

}  // namespace mikromakro::styles
