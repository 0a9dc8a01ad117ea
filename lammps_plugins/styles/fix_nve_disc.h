// fix nve/disc: velocity Verlet for x, y and the spin about z of discs; what is not in the plane is left
// alone.
#pragma once

#include <vector>

#include "dialect.h"
#include "last_forces.h"
#include "physics/disc_rows.h"

namespace mikromakro::styles {

class DiscLaw;
struct PackedDiscs;

/// fix ID group nve/disc [velocity predicted | half_step]
///
/// m dv/dt = f, I domega/dt = T with I = m a^2 / 2. Forces that depend on velocities are evaluated with the
/// velocities of the same instant as the positions: between the two half-kicks the atoms carry the prediction
/// v(t) + dt f(t)/m, which differs from the final velocity by O(dt^2), and the half-kicked velocity waits in
/// this fix. `velocity half_step` is what the stock integrators do: the dashpot then sees v(t + dt/2), an
/// error of order gamma dt / 2m.
///
/// A run goes on with the forces of the last step, also from a restart file if the fix has the same id there:
/// on the same number of ranks it repeats, bit for bit, the run that was not interrupted but wrote its file
/// on the way (`restart N FILE`; the engine builds the neighbour list anew in such a step, as the set-up of a
/// run does). Forces that a script adds between two runs act from the new run's first evaluation on, half a
/// step later.
///
/// Where nobody looks at a disc between two steps, this fix does the final half-kick of a step together with
/// the first one of the next (packed_discs.h): the same arithmetic, and the same bits.
class FixNveDisc : public FixOfEngine {
 public:
  FixNveDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);
  ~FixNveDisc() override;
  FixNveDisc(const FixNveDisc&) = delete;
  FixNveDisc& operator=(const FixNveDisc&) = delete;

  bool predicts_velocities() const { return predicted_; }

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void setup_pre_exchange() override;
  void initial_integrate(int vflag) override;
  void post_integrate() override;
  void pre_exchange() override;
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

 private:
  /// Before the first half-kick of a step, and after the second one of a step that ends closed.
  void go_on_from_last_run();
  void note_end_of_step();
  void find_members();
  void begin_step();
  void go_on();
  void end_step();
  bool neighbours_suffice();

  bool predicted_ = true;
  DiscLaw* law_ = nullptr;
  PackedDiscs* packed_ = nullptr;
  // Of each owned atom, between the two half-kicks and between the steps of an open state.
  struct HalfStep {
    physics::Four values;  // v_x, v_y [m/s], spin [1/s]; dt / 2m, which turns a force into a half-kick
  };
  static constexpr int size_of_half_step = 5;  // numbers that go with a disc to another rank
  std::vector<HalfStep> half_steps_;
  std::vector<double> spin_kicks_;     // dt / 2I
  std::vector<int> members_, others_;  // local numbers of the discs of the group, and of all others
  std::vector<int> seen_elsewhere_;    // local numbers of discs that have ghosts
  bool members_known_ = false;
  LAMMPS_NS::bigint next_question_ = 0;  // the step of it; see neighbours_suffice()
  LastForces last_forces_;
  bool resumes_ = false;        // the next step is the first of a run
  bool step_complete_ = false;  // forces and velocities are those of the end of a step
};

}  // namespace mikromakro::styles
