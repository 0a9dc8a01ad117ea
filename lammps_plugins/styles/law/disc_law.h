// SPDX-License-Identifier: GPL-2.0-or-later
// Engine-independent part of the pair style. The engine's own class parses the script, fetches material
// constants and supplies neighbour lists and contact histories; this class loops over the pairs in two
// dimensions and adds forces and torques. The force law itself is in physics/contact/contact_law.h.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "law/contact_rows.h"
#include "law/packed_discs.h"
#include "physics/contact/contact_batch.h"
#include "physics/contact/contact_law.h"
#include "physics/contact/near_pairs.h"
#include "physics/math/plane_vector.h"
#include "pointers.h"

namespace LAMMPS_NS {
class NeighList;
}

namespace mikromakro::styles {

class Arguments;
class DiscIntegrator;

/// A contact as applied in the last force evaluation; signs as in physics/contact/contact_law.h.
struct AppliedContact {
  int i, j;  // local indices; i is owned, j may be a ghost
  double n_x, n_y, overlap;
  physics::ContactForce force;
  double v_n, v_t;
};

/// A material constant as given, for types i, j at (i - 1) * types + j - 1.
struct MaterialConstant {
  std::string name, unit;
  std::vector<double> values;
  bool operator==(const MaterialConstant& other) const {
    return name == other.name && unit == other.unit && values == other.values;
  }
};

class DiscLaw : protected LAMMPS_NS::Pointers {
  friend class AddedLoads;
  friend class CarriedDiscs;

 public:
  explicit DiscLaw(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}
  ~DiscLaw() override = default;
  DiscLaw(const DiscLaw&) = delete;
  DiscLaw& operator=(const DiscLaw&) = delete;

  /// Name of the pair style, as prefix of error messages.
  virtual std::string style() const = 0;
  /// The material constants given in the script.
  virtual std::vector<MaterialConstant> given_constants() const = 0;
  /// Makes the engine copy contact histories from the neighbour list to the atoms, for restart files and
  /// migration to other ranks.
  virtual void keep_springs_with_atoms() = 0;

  /// Contacts of this step's force evaluation; nullptr if the step was not recorded.
  const std::vector<AppliedContact>* applied_contacts() const;
  physics::Effects effects() const { return effects_; }
  /// Without friction, spins do not change and are not loaded.
  bool rows_have_spins() const { return effects_.tangential != physics::Tangential::none; }
  /// Memory of pairs and contacts, in this class and in the engine's contact histories.
  std::size_t bytes_of_pairs() const;
  std::size_t bytes_in_engine() const;
  /// Current number of touching pairs on this rank.
  std::size_t contacts() const;
  /// For walls, which use the same law: constants of two types (counted from 1), and whether velocities are
  /// predicted for the time of the positions. Valid from the start of a run.
  const physics::ContactParameters& parameters(int type_1, int type_2) const;
  bool velocities_predicted() const { return predicted_; }
  /// An owned disc as used in this step's contact evaluation; nullptr before the evaluation.
  const physics::DiscRow* seen(int i) const;
  /// Warns, once per run, if a recorded overlap exceeds half of the smaller radius. Collective.
  void tell_of_deep_overlaps();
  /// Largest elastic contact force on this rank [N].
  double strongest_contact() const;
  /// Largest radius of each type [m], which the engine's neighbour lists are made for: over all ranks at the
  /// start of the run, including discs that fixes will insert.
  double largest_radius(int type) const { return largest_radii_[type]; }

  /// Packed disc data, for the fix that integrates; other fixes use fixes_in_step.h.
  PackedDiscs& packed_discs(const DiscIntegrator& /*asks*/) { return packed_; }
  /// Whether the loads of the last force evaluation are in the packed disc data, not in the engine.
  bool step_is_open() const { return packed_.open; }
  /// Whether steps of this run may be open.
  bool may_stay_open() const { return packed_.may_stay_open; }
  /// With fused half-kicks ("open" state), contact forces are not needed until the next step begins; each
  /// disc is then moved as soon as all its contacts have been evaluated, while its row is still in cache.
  /// Call before reading loads; the integrator passes a function that advances all discs with index < before.
  using MoveDiscs = std::function<void(int before)>;
  void complete_step(const MoveDiscs& move_discs = {});
  /// Writes pending data back to the engine's arrays: positions and velocities of the rows, loads, springs.
  void close();
  void put_discs_into_engine();
  void put_disc_into_engine(int i);
  void put_springs_into_engine();
  /// True if nothing reads end-of-step data in this step.
  bool will_stay_open() const { return packed_.may_stay_open && !readers_.any_at_present_step(*lmp); }
  /// Number of steps, including this one (whose rows must be up to date), within which no disc can move
  /// beyond half the skin of the neighbour list, provided none exceeds six times the current maximum speed.
  int steps_neighbours_suffice();
  /// Number of steps for which the inner list stays valid at the present speed.
  int steps_near_pairs_suffice() const;

 protected:
  /// Columns of the engine's contact history.
  static constexpr int history_xi = 0, history_slip_rate = 1, history_size = 2;

  /// The engine's history arrays that accompany its neighbour list: for neighbour k of disc i, whether the
  /// two touch, and its values from values[i] + stride k on.
  struct History {
    int** touching;
    double** values;
    int stride;
  };
  /// One call of the engine's pair style.
  struct Evaluation {
    const LAMMPS_NS::NeighList& list;
    bool is_step;        // false: re-evaluation for output
    bool moves_springs;  // false in a set-up
    bool is_observed;    // the engine wants each contact: see tell_engine()
  };
  /// A contact for the engine's own tallies: force and torque on disc i, vector from i to j.
  struct ObservedContact {
    int i, j;
    double d_x, d_y, overlap, f_x, f_y, torque;
    double* history;  // nullptr for laws without a spring
  };

  virtual History history() = 0;
  virtual void tell_engine(const ObservedContact& contact) = 0;

  [[noreturn]] void fail(const std::string& what) const;
  void require_two_dimensions() const;

  // Settings of the pair style: forget_settings(), any number of take_setting(), use_settings().
  void forget_settings(physics::Normal normal, physics::Tangential tangential);
  bool take_setting(Arguments& arguments);  // false: not a keyword of the law
  bool take_switch(Arguments& arguments, const char* key, bool& value) const;
  void set_tangential(physics::Tangential tangential) { effects_.tangential = tangential; }
  void use_settings();
  /// `key` identifies the pair style in a restart file.
  void write_settings(std::FILE* file, std::int64_t key) const;
  void read_settings(std::FILE* file, std::int64_t key);

  /// Call at the start of a run, with the constants of types i, j at (i - 1) * types + j - 1.
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
  /// Upper bounds, over all discs, on displacement and radius growth since the previous evaluation [m].
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
  double impact_velocity_ = 0;  // expected, for the time step check [m/s]; 0: not given
  bool run_started_ = false;
  std::vector<physics::ContactParameters> parameters_;  // of types i, j at (i - 1) * types + j - 1
  PackedDiscs packed_;
  std::vector<DiscIntegrator*> integrators_;
  LAMMPS_NS::bigint rows_step_ = -1;  // step that the rows belong to
  EndOfStepReaders readers_;
  std::unique_ptr<physics::ContactBatch> batch_ = std::make_unique<physics::ContactBatch>();
  // Flattened neighbour list, renewed with each build: its pairs and the first pair of each disc; for laws
  // with a spring also the engine's contact flags and histories, and which pairs touched in the last step.
  std::vector<physics::DiscPair> pairs_;
  bool pairs_known_ = false;
  std::vector<int> first_pair_;
  int** flags_ = nullptr;
  std::vector<double*> histories_;
  std::vector<char> in_contact_;
  // Inner list, and since it was last pruned: upper bound on the displacement of any disc [m], number of
  // steps.
  physics::NearPairs near_;
  double near_gap_ = 0, moved_ = 0;
  int steps_of_near_ = 0;
  double fastest_path_ = 0;  // longest path per step, at recent speeds [m]
  // Positions of owned discs at the last neighbour list build, and the upper bound on their displacement
  // since [m].
  std::vector<physics::PlaneVector> built_at_;
  double path_ = 0;
  // Radii [m]: see largest_radius(); the excess over the radii that the present lists were made for; the
  // largest growth in the last step.
  std::vector<double> largest_radii_;
  double beyond_lists_ = 0, growth_ = 0;
  double sum_of_radii_ = 0;        // of all discs, before the set-up [m]
  bool lists_are_old_ = false;     // radii grew during the set-up itself
  bool forces_are_stale_ = false;  // engine forces not cleared in this step
  bool springs_wait_ = false;      // contact history not yet written back
  bool one_material_ = false;      // one set of constants for all types
  bool ordered_ = false;           // pairs sorted by first disc i, and i < j
  std::optional<Evaluation> waiting_;
  LAMMPS_NS::bigint evaluated_step_ = -1;
  Preparation preparation_ = nullptr;
  Loop plain_loop_ = nullptr;
  Loop observed_loop_ = nullptr;
  // Velocities are predicted for the time of the positions.
  bool predicted_ = false;
  ContactSchedule schedule_;
  bool recording_ = false;
  bool deep_overlaps_told_ = false;
  LAMMPS_NS::bigint recorded_step_ = -1;
  std::vector<AppliedContact> applied_;
};

}  // namespace mikromakro::styles
