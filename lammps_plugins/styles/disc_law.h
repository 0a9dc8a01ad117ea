// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law of an engine's pair style: everything of it that engines have in common. An engine's own
// class parses what its scripts look like, fetches material constants and hands over neighbour lists and
// springs; this one loops over the pairs in two dimensions and adds forces and torques. The arithmetic of the
// law is in physics/contact_law.h.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact_rows.h"
#include "packed_discs.h"
#include "physics/contact_batch.h"
#include "physics/contact_law.h"
#include "physics/near_pairs.h"
#include "physics/plane_vector.h"
#include "pointers.h"

namespace LAMMPS_NS {
class NeighList;
}

namespace mikromakro::styles {

class Arguments;
class FixNveDisc;

/// One contact as it acted in the last force evaluation; signs as in physics/contact_law.h.
struct AppliedContact {
  int i, j;  // local indices; i is owned, j may be a ghost
  double n_x, n_y, overlap;
  physics::ContactForce force;
  double v_n, v_t;
};

/// A constant of the law as it was given, for all pairs of types at (i - 1) * types + j - 1.
struct MaterialConstant {
  std::string name, unit;
  std::vector<double> values;
  bool operator==(const MaterialConstant& other) const {
    return name == other.name && unit == other.unit && values == other.values;
  }
};

class DiscLaw : protected LAMMPS_NS::Pointers {
 public:
  explicit DiscLaw(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  ~DiscLaw() override = default;
  DiscLaw(const DiscLaw&) = delete;
  DiscLaw& operator=(const DiscLaw&) = delete;

  /// As error lines begin.
  virtual std::string style() const = 0;
  /// The constants that a script has given.
  virtual std::vector<MaterialConstant> given_constants() const = 0;
  /// Has the engine copy springs from the pairs of the neighbour list to the atoms, with which they go into
  /// files and to other ranks.
  virtual void keep_springs_with_atoms() = 0;

  /// The contacts of the force evaluation of this step; nullptr where the step was not recorded.
  const std::vector<AppliedContact>* applied_contacts() const;
  physics::Effects effects() const { return effects_; }
  /// Without friction spins do not change, and are not read.
  bool rows_have_spins() const { return effects_.tangential != physics::Tangential::none; }
  /// What the law itself holds of pairs and contacts at present, and the engine in its lists of springs.
  std::size_t bytes_of_pairs() const;
  std::size_t bytes_in_engine() const;
  /// Pairs of this rank that touch at present.
  std::size_t contacts() const;
  /// For walls, which act under the same law: constants of two types (from 1 on), and whether the atoms carry
  /// velocities that were predicted for the instant of their positions. Valid from the start of a run.
  const physics::ContactParameters& parameters(int type_1, int type_2) const;
  bool velocities_predicted() const { return predicted_; }
  /// An owned disc as its contacts saw it in this step; nullptr where they have not been evaluated.
  const physics::DiscRow* seen(int i) const;
  /// One warning in each run where recorded contacts overlap by more than half of the smaller radius. Called
  /// by all ranks together.
  void tell_of_deep_overlaps();
  /// Elastic force of the contact of this rank that is pressed most [N].
  double strongest_contact() const;
  /// Of each type [m], for which the engine makes its lists: of all ranks at the start of the run, and of
  /// discs that fixes are going to insert.
  double largest_radius(int type) const { return largest_radii_[type]; }

  /// Shared with the fixes that move discs.
  PackedDiscs& packed_discs() { return packed_; }
  /// While the state is open, contacts need not act before the next step begins: then discs are moved on as
  /// soon as all their contacts have acted, while their rows are still in the processor's cache. Whoever
  /// looks at loads before calls this one; whoever integrates gives what moves on all discs before a number.
  using MoveDiscs = std::function<void(int before)>;
  void complete_step(const MoveDiscs& move_discs = {});
  /// Puts what waits here into the engine's arrays: places and velocities of the rows, loads, springs.
  void close();
  void put_discs_into_engine();
  void put_disc_into_engine(int i);
  void put_springs_into_engine();
  /// Whether nobody looks at the end of the present step.
  bool will_stay_open() const { return packed_.may_stay_open && !readers_.any_at_present_step(*lmp); }
  /// For how many steps, this one included, for which rows are there, no disc can leave its half of the
  /// neighbour list's skin while none gets faster than six times the fastest one now.
  int steps_neighbours_suffice();
  /// For how many of them no pair can have come so close, at the present speed, that the near ones have to be
  /// found anew.
  int steps_near_pairs_suffice() const;

 protected:
  /// Columns of the springs in an engine's history of contacts.
  static constexpr int history_xi = 0, history_slip_rate = 1, history_size = 2;

  /// The engine's lists beside its neighbour list: of disc i and its neighbour number k, whether they touch,
  /// and from values[i] + stride k on their spring.
  struct History {
    int** touching;
    double** values;
    int stride;
  };
  /// One call of the engine's pair style.
  struct Evaluation {
    const LAMMPS_NS::NeighList& list;
    bool is_step;        // the forces act; otherwise somebody asks for them again
    bool moves_springs;  // not in a set-up
    bool is_observed;    // the engine wants each contact, see tell_engine()
  };
  /// A contact for the engine's own sums: force and torque on disc i, vector from i to j.
  struct ObservedContact {
    int i, j;
    double d_x, d_y, overlap, f_x, f_y, torque;
    double* history;  // nullptr where the law has no spring
  };

  virtual History history() = 0;
  virtual void tell_engine(const ObservedContact& contact) = 0;

  [[noreturn]] void fail(const std::string& what) const;
  void require_two_dimensions() const;

  // Settings of the pair style: forget_settings(), any number of take_setting(), use_settings().
  void forget_settings(physics::Normal normal, physics::Tangential tangential);
  bool take_setting(Arguments& arguments);  // false: the next argument is no keyword of the law
  bool take_switch(Arguments& arguments, const char* key, bool& value) const;
  void set_tangential(physics::Tangential tangential) { effects_.tangential = tangential; }
  void use_settings();
  /// `key` tells the pair style in a restart file.
  void write_settings(std::FILE* file, std::int64_t key) const;
  void read_settings(std::FILE* file, std::int64_t key);

  /// At the start of a run, with the constants of types i, j at (i - 1) * types + j - 1.
  void begin_run(std::vector<physics::ContactParameters> parameters);
  void evaluate(const Evaluation& evaluation);

 private:
  using Preparation = void (DiscLaw::*)(const Evaluation& evaluation);
  using Loop = void (DiscLaw::*)(const Evaluation& evaluation, const MoveDiscs& move_discs);

  void start_run(const LAMMPS_NS::NeighList& list);
  void find_integrators();
  void find_largest_radii();
  double sum_of_radii() const;
  void choose_loops();
  template <int... numbers>
  void choose_among(std::integer_sequence<int, numbers...> combinations);
  template <physics::Effects effects>
  void use_loops_of();
  /// What has happened to discs since the evaluation before: how far any has moved, and how much any radius
  /// has grown, at most [m].
  struct Change {
    double moved, growth;
  };
  template <bool spins>
  Change gather(int first);
  template <physics::Effects effects>
  void flatten(const LAMMPS_NS::NeighList& list);
  void remember_places();
  void follow_growth(double growth);
  void lessen_trigger(double by);
  template <physics::Effects effects>
  void find_near_pairs();
  void set_materials(physics::ContactBatch& batch, const physics::DiscPair* pairs, int count) const;
  void begin_and_end_contacts(physics::ContactBatch& batch, int first, int count, double dt);
  void observe(const Evaluation& evaluation, const physics::ContactBatch& batch, int lane, int first);
  [[noreturn]] void stop_alone(const std::string& what) const;
  [[noreturn]] void stop_at_coincident_centres(const physics::ContactBatch& batch,
                                               const physics::DiscPair* pairs) const;
  template <physics::Effects effects>
  void prepare(const Evaluation& evaluation);
  template <physics::Effects effects, bool observed>
  void act(const Evaluation& evaluation, const MoveDiscs& move_discs);

  physics::Effects effects_;
  bool tangential_damping_ = false;
  double impact_velocity_ = 0;  // [m/s] to be expected, for the time step; 0: not given
  bool run_started_ = false;
  std::vector<physics::ContactParameters> parameters_;  // of type i and type j at (i - 1) * types + j - 1
  PackedDiscs packed_;
  std::vector<FixNveDisc*> integrators_;
  LAMMPS_NS::bigint rows_step_ = -1;  // of which the rows are
  EndOfStepReaders readers_;
  std::unique_ptr<physics::ContactBatch> batch_ = std::make_unique<physics::ContactBatch>();
  // Since the neighbour list was built: its pairs, the first of each disc, and for laws with a spring the
  // engine's flags and histories of contacts, and which pairs touched in the last step.
  std::vector<physics::DiscPair> pairs_;
  bool pairs_known_ = false;
  std::vector<int> first_pair_;
  int** flags_ = nullptr;
  std::vector<double*> histories_;
  std::vector<char> in_contact_;
  // Since the last look at all pairs: those that may touch, how far any disc has moved at most [m], steps.
  physics::NearPairs near_;
  double near_gap_ = 0, moved_ = 0;
  int steps_of_near_ = 0;
  double fastest_path_ = 0;  // of any disc in a step, of late [m]
  // Since the neighbour list was built: where owned discs were then, how far any has moved at most [m].
  std::vector<physics::PlaneVector> built_at_;
  double path_ = 0;
  // Radii [m]: see largest_radius(); how far they reach beyond what the present lists were made for, and how
  // much any has grown in the last step, at most.
  std::vector<double> largest_radii_;
  double beyond_lists_ = 0, growth_ = 0;
  double sum_of_radii_ = 0;        // of all discs, before the set-up of the run [m]
  bool lists_are_old_ = false;     // radii have grown since, in the set-up itself
  bool forces_are_stale_ = false;  // the engine has not cleared its forces in this step
  bool springs_wait_ = false;      // the engine's histories are behind
  bool one_material_ = false;      // all pairs of types have the same constants
  bool ordered_ = false;           // pairs ascend in their first disc, whose number is the smaller one
  std::optional<Evaluation> waiting_;
  LAMMPS_NS::bigint evaluated_step_ = -1;
  Preparation preparation_ = nullptr;
  Loop plain_loop_ = nullptr;
  Loop observed_loop_ = nullptr;
  // The atoms carry velocities that were predicted for the instant of their positions.
  bool predicted_ = false;
  ContactSchedule schedule_;
  bool recording_ = false;
  bool deep_overlaps_told_ = false;
  LAMMPS_NS::bigint recorded_step_ = -1;
  std::vector<AppliedContact> applied_;
};

}  // namespace mikromakro::styles
