// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group biaxial/2d type T left X CONTROL right X CONTROL bottom Y CONTROL top Y CONTROL [height H]
//
// Four smooth flat walls that always form a rectangle around the discs of the group: each moves along its
// normal only. X, Y: where they stand at first (m). CONTROL is one of
//   fixed
//   strain cosine X_END TIME       from where the wall stands to X_END (m) within TIME (s) along a half
//   cosine,
//                                  then it stays
//   strain rate V                  with the velocity V (m/s) along x or y
//   stress P mass M damping G      m x'' = F - P L - G x' outwards (physics/servo_wall.h): F the discs' force
//   on the
//                                  wall, L its length between its neighbours; P in N/m, or in Pa where a
//                                  height H (m) is given; M in kg, G in kg/s
// type T, before the first wall: the atom type whose material constants the walls have; behind a wall: that
// of this wall. A wall is frictionless where its constant mu with the types of the discs is 0. All under the
// law of the pair style (physics/smooth_wall.h). Contact rows show the walls with the ids -1, -2, -3, -4.
//
// fix_modify ID WALL CONTROL ... [reset]: changes how walls move, from where and as fast as they are. reset:
// strains and works count from here on. A fix that continues from a restart file takes the walls where they
// stood; one whose CONTROL is the same as before goes on with it.
//
// A stress-controlled wall whose half period pi sqrt(M/K) on its contacts of stiffness K is shorter than 50
// time steps is warned of, below 4 refused, at the start and at the end of each run.
//
// Scalar: work of all walls on the discs (J). Vector, walls in the order left right bottom top:
//    1 - 4   positions, m                          5 - 8   velocities along x or y, m/s
//    9 - 12  forces that press them outwards, N   13 - 16  the same over their length (and H): N/m or Pa
//   17 - 19  strains: horizontal, vertical (L/L_0 - 1), of the area; negative in compression
//   20 - 23  work on the discs, J                 24 - 27  forces along them (in x or y), N
#pragma once

#include <array>

#include "agreement.h"
#include "biaxial_settings.h"
#include "fix_with_walls.h"
#include "physics/servo_wall.h"
#include "physics/step_clock.h"

namespace mikromakro::styles {

class FixBiaxial2d : public FixWithWalls, public KnowsHeight {
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

 protected:
  int calls_wanted() const override;
  void once_defined() override;
  void run_ended() override;
  void count_steps_anew(LAMMPS_NS::bigint shift) override;

 private:
  // A wall in motion; where its control began, and what it has done since the last reset.
  struct Wall {
    WallControl control;
    physics::ServoWall motion;  // along x or y
    double contact_velocity;    // that the discs see (m/s)
    double start, start_time;   // m, s
    double pressing, along;     // forces of the last evaluation (N)
    double previous_position, previous_pressing;
    double work;  // J
    // The acceleration and the previous force are those of the last step, with which a run goes on: dashpots
    // of the set-up see other velocities.
    bool goes_on = false;
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
  [[nodiscard]] std::array<double, 4> stiffness_of_contacts() const;  // N/m
  void check_time_step() const;
  [[nodiscard]] std::vector<physics::SmoothWall> smooth_walls() const;
  void sum_forces();

  BiaxialSettings settings_;
  std::array<Wall, 4> box_{};
  std::array<double, 2> reference_lengths_{};  // of strains (m)
  physics::StepClock clock_;
};

}  // namespace mikromakro::styles
