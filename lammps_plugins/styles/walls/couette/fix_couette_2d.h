// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group couette/2d center X Y inner RING outer RING omega_inner W
//                        [omega_outer W] [compact R_END TIME] [height H]
// RING: rough GROUP R  or  smooth TYPE R
//
// The rings of a 2D Couette shear cell about (X, Y) (m). Rough ring: the wall discs of a group, with their
// centres on the circle of radius R (R_I, R_O below; m). Their positions and velocities are functions of time
// only (physics/motion/ring_motion.h), whatever the forces, so no rounding error accumulates. W: rotation
// rates (1/s, counter-clockwise positive). `compact`: the outer radius changes from R_O to R_END (m) within
// TIME (s) along a half cosine. `group` must contain the wall discs of rough rings, which no other fix may
// integrate. Keywords may come in any order.
//
// A smooth ring is a circular wall of radius R with the material constants of TYPE. It acts on all discs of
// `group` except wall discs, under the law of the pair style (physics/walls/smooth_wall.h). Its id in contact
// rows is 0 (inner) or -5 (outer).
//
// A new fix takes the present angles of the wall discs as zero. Time continues across runs, changes of the
// time step and restarts.
//
// Scalar: the wheel torque, f_ID[1]. Vector (of the last force evaluation; gathered only on request):
//   1  torque of the discs on the inner ring (the wheel) about the centre, N m; counter-clockwise positive,
//      so it is negative if the wheel turns counter-clockwise against resistance: T = 2 pi r^2 h sigma_phir
//   2  the same for the outer ring
//   3  pressure on the inner ring: force away from the discs over 2 pi R_I, N/m; over 2 pi R_I H, Pa, if a
//      height H (m) is given; positive in compression
//   4  the same for the outer ring
//   5  angle turned by the inner ring, rad        6  by the outer ring
//   7  radius of the outer ring, m                8  its rate, m/s
//   9  power that the wheel feeds into the discs, W
#pragma once

#include <array>
#include <vector>

#include "dialect.h"
#include "law/agreement.h"
#include "law/fix_on_rows.h"
#include "physics/motion/ring_motion.h"
#include "physics/motion/step_clock.h"
#include "physics/walls/ring_load.h"
#include "walls/couette/couette_settings.h"
#include "walls/smooth_walls.h"
#include "walls/walls_of_restart.h"

namespace mikromakro::styles {

class DiscLaw;

class FixCouette2d : public FixWithClock, public WallContactSource, public FixOnRows, public KnowsHeight {
 public:
  FixCouette2d(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixCouette2d() override;
  FixCouette2d(const FixCouette2d&) = delete;
  FixCouette2d& operator=(const FixCouette2d&) = delete;

  double given_height() const override { return settings_.height == 1.0 ? 0.0 : settings_.height; }

  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void post_force(int vflag) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int i) override;
  double memory_usage() override;

  void grow_arrays(int nmax) override;
  void copy_arrays(int i, int j, int delflag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buf) override;
  int unpack_exchange(int nlocal, double* buf) override;

  void write_restart(FILE* fp) override;
  void restart(char* buf) override;
  int pack_restart(int i, double* buf) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int nlocal) override;
  int maxsize_restart() override;

  bool append_wall_contacts(int group_bit, std::vector<ContactRow>& rows) const override {
    return walls_.append_contacts(group_bit, rows);
  }
  std::vector<WallKind> wall_kinds() const override { return walls_.kinds(); }
  std::vector<WallTouch> touches() const override { return walls_.touches(); }

  int calls_on_rows() const override {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | PRE_EXCHANGE | POST_FORCE;
  }

 protected:
  int calls_wanted() const override;
  void once_defined() override;
  void renumber_steps(LAMMPS_NS::bigint shift) override;

 private:
  using Rings = std::array<physics::RingState, 2>;  // inner, outer
  using Loads = std::array<physics::RingLoad, 2>;

  [[nodiscard]] Rings rings_at(LAMMPS_NS::bigint step) const;
  [[nodiscard]] int ring_of(int i) const;  // 0 inner, 1 outer, -1 not a wall disc
  [[nodiscard]] physics::PlaneVector from_centre(int i) const;
  void follow_time_step(LAMMPS_NS::bigint step);
  void check_groups();
  void check_integrators() const;
  void check_radii();
  void adopt_new_wall_discs();
  void place_wall_discs(LAMMPS_NS::bigint step, bool velocities_only);
  void add_smooth_rings();
  [[nodiscard]] std::vector<physics::SmoothWall> smooth_rings_at(LAMMPS_NS::bigint step) const;
  void add_loads_of_smooth_rings();
  void find_members();
  void carry_rows(LAMMPS_NS::bigint step);
  const Loads& loads();

  CouetteSettings settings_;
  physics::StepClock clock_;
  double** references_ = nullptr;  // per atom: unit vector of the reference angle; zero: not set
  SmoothWalls walls_;              // of the smooth rings
  WallsOfRestart saved_walls_;
  DiscLaw* law_ = nullptr;
  std::array<std::vector<int>, 2> members_;  // local indices of the wall discs of both rings
  bool members_known_ = false;
  Loads loads_;
  LAMMPS_NS::bigint step_of_loads_ = -1;
};

}  // namespace mikromakro::styles
