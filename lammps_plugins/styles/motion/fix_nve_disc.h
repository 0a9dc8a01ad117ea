// SPDX-License-Identifier: GPL-2.0-or-later
// fix nve/disc: velocity Verlet for x, y and the spin about z of discs; out-of-plane components are
// untouched.
#pragma once

#include <vector>

#include "dialect.h"
#include "law/fix_on_rows.h"
#include "motion/last_forces.h"
#include "physics/rows/disc_rows.h"

namespace mikromakro::styles {

class DiscLaw;
struct SharedStep;

/// fix ID group nve/disc [velocity predicted | half_step] [fused on | off]
///
/// m dv/dt = f, I domega/dt = T with I = m a^2 / 2. Between the two half-kicks of a step the engine's arrays
/// hold mid-step velocities, as with the stock integrators, so that other fixes work as usual. Contacts of
/// the disc law, smooth walls and the bottom use velocities at the time of the positions: this fix stores for
/// each disc the difference to the prediction v(t) + dt f(t)/m, which differs from the final velocity by
/// O(dt^2), and adds it to the rows of packed_discs.h. `velocity half_step` does as the stock integrators:
/// the dashpot then sees v(t + dt/2), an error of order gamma dt / 2m.
///
/// A run continues with the forces of the last step, if nothing has changed since (last_forces.h); also from
/// a restart file if the fix has the same id there. On the same number of ranks it then reproduces, bit for
/// bit, the uninterrupted run that wrote the file on the way (`restart N FILE`: the engine rebuilds the
/// neighbour list in such a step, as the set-up of a run does).
///
/// If nothing acts on or reads the discs between two steps, the final half-kick of a step is fused with the
/// first one of the next (packed_discs.h), with the same arithmetic and the same bits. `fused off` keeps the
/// two apart in all steps.
class FixNveDisc : public FixOfEngine, public DiscIntegrator {
 public:
  FixNveDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);
  ~FixNveDisc() override;
  FixNveDisc(const FixNveDisc&) = delete;
  FixNveDisc& operator=(const FixNveDisc&) = delete;

  bool predicts_velocities() const override { return predicted_; }
  void predict(std::vector<physics::DiscRow>& rows, int first) const override;
  void send_to_ghosts() override;

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void setup_pre_exchange() override;
  void setup_pre_force(int vflag) override;
  void initial_integrate(int vflag) override;
  void post_integrate() override;
  void pre_exchange() override;
  void pre_force(int vflag) override;
  void final_integrate() override;
  void post_run() override;

  void grow_arrays(int nmax) override;
  void copy_arrays(int from, int to, int delflag) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  void set_arrays(int i) override;
  double memory_usage() override;

  void write_restart(FILE* file) override;
  void restart(char* /*buffer*/) override {}
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int nlocal) override;
  int maxsize_restart() override;

 protected:
  void pack_for_ghost(int i, double* buffer) const override;
  void unpack_for_ghost(int i, const double* buffer) override;

 private:
  void read_options(int narg, char** arg);
  void check_run() const;
  /// Called before the first half-kick of a step, and after the second one of a step that ends closed.
  void resume_last_run();
  void note_end_of_step();
  void keep_last_forces();
  void find_members();
  void pack_prediction(int i, double* buffer) const;
  void unpack_prediction(int i, const double* buffer);
  void begin_step();
  void store_half_steps();
  void begin_fused_step();
  void end_step();
  bool lists_stay_valid();

  bool predicted_ = true, fused_ = true;
  bool predicts_ = false;  // in this run: the disc law uses predictions
  DiscLaw* law_ = nullptr;
  SharedStep* shared_ = nullptr;  // of the law
  // How predict() uses the stored values of each disc, owned or ghost. none: not between the two half-kicks
  // of a step; differences: within a step, added to v_x, v_y and the spin; velocities: in the set-up of a
  // continued run, replace them.
  enum class Prediction { none, differences, velocities };
  Prediction prediction_ = Prediction::none;
  struct OfDisc {
    physics::Four values;
  };
  std::vector<OfDisc> predictions_;
  // Per owned atom, between open steps: v_x, v_y [m/s] and spin [1/s] at mid-step; dt / 2m,
  // which turns a force into a half-kick; and dt / 2I.
  static constexpr int size_of_half_step = 5, size_of_prediction = 3;  // doubles sent to another rank
  static constexpr int size_for_ghosts = size_of_prediction + 1;
  std::vector<OfDisc> half_steps_;
  std::vector<double> spin_kicks_;
  bool half_steps_pending_ = false;    // mid-step velocities are here, not in the engine
  std::vector<int> members_, others_;  // local indices of discs in the group, and of all others
  std::vector<int> with_ghosts_;       // local indices of discs that have ghosts
  bool members_known_ = false;
  LAMMPS_NS::bigint next_check_ = 0;  // step of the next check: see lists_stay_valid()
  LastForces last_forces_;
  bool resumes_ = false;                    // the next step is the first of a continued run
  bool step_complete_ = false;              // forces and velocities are those of the end of a step
  LAMMPS_NS::bigint velocities_step_ = -1;  // step whose contact velocities last_forces_ holds
};

}  // namespace mikromakro::styles
