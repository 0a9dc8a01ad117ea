// pair_style gran model disc/linear|disc/hertz tangential off|disc/viscous|disc/cundall_strack: the adapter
// between LIGGGHTS and the contact law of physics/contact_law.h. It parses the settings, fetches the material
// constants, loops over the pairs of the engine's neighbour list in two dimensions and adds forces and
// torques; the arithmetic of the law is not here.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contact_rows.h"
#include "granular_pair_style.h"
#include "packed_discs.h"
#include "physics/contact_batch.h"
#include "physics/contact_law.h"
#include "physics/near_pairs.h"
#include "physics/plane_vector.h"
#include "pointers.h"

namespace mikromakro::liggghts {

class Arguments;

/// Ids under which the factories of LIGGGHTS know our models: 6 bits; the engine's own are below 32.
inline constexpr int normal_model_linear = 32;
inline constexpr int normal_model_hertz = 33;
inline constexpr int tangential_model_viscous = 32;
inline constexpr int tangential_model_cundall_strack = 33;

/// One contact as it acted in the last force evaluation; signs as in physics/contact_law.h.
struct AppliedContact {
  int i, j;  // local indices; i is owned, j may be a ghost
  double n_x, n_y, overlap;
  physics::ContactForce force;
  double v_n, v_t;
};

class PairGranDisc : public LIGGGHTS::PairStyles::IGranularPairStyle, protected LAMMPS_NS::Pointers {
 public:
  PairGranDisc(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::PairGran* parent, int64_t hash);

  void settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* history) override;
  void init_granular() override;
  void write_restart_settings(FILE* file) override;
  void read_restart_settings(FILE* file, int64_t hash) override;
  void compute_force(LAMMPS_NS::PairGran* pair, int eflag, int vflag, int addflag) override;

  int get_history_offset(const std::string name) override;
  double stressStrainExponent() override { return effects_.normal == physics::Normal::hertz ? 1.5 : 1.0; }
  int64_t hashcode() override { return hash_; }
  bool contact_match(const std::string kind, const std::string model) override;

  /// The contacts of the force evaluation of this step; nullptr where the step was not recorded.
  const std::vector<AppliedContact>* applied_contacts() const;
  physics::Effects effects() const { return effects_; }
  /// What the law itself holds of pairs and contacts at present, and the engine in its lists of springs.
  std::size_t bytes_of_pairs() const;
  std::size_t bytes_in_engine() const;
  /// Pairs of this rank that touch at present.
  std::size_t contacts() const;
  /// For walls, which act under the same law: constants of two types (from 1 on), and whether the atoms carry
  /// velocities that were predicted for the instant of their positions. Valid from the start of a run.
  const physics::ContactParameters& parameters(int type_1, int type_2) const;
  bool velocities_predicted() const { return predicted_; }

  /// Shared with the fixes that move discs.
  PackedDiscs& packed_discs() { return packed_; }
  /// Puts what waits here into the engine's arrays: places and velocities of the rows, loads, springs.
  void close();
  void put_discs_into_engine();
  void put_disc_into_engine(int i);
  void put_springs_into_engine();
  /// Whether nobody looks at the end of the present step.
  bool will_stay_open() const { return packed_.may_stay_open && !readers_.any_at_present_step(*lmp); }
  /// Whether no disc can have left its half of the neighbour list's skin, in a step for which rows are there.
  bool neighbours_suffice();
  /// Whether no pair can have come so close, in such a step, that the near ones have to be found anew.
  bool near_pairs_suffice() const { return 2 * (moved_ + packed_.furthest) <= near_gap_; }

 private:
  using Loop = void (PairGranDisc::*)(LAMMPS_NS::PairGran&, bool addflag);

  std::string style() const;  // as error lines begin
  [[noreturn]] void fail(const std::string& what) const;
  void require_two_dimensions() const;
  /// If the next argument is the keyword, takes it and its on or off.
  bool take_switch(Arguments& arguments, const char* key, bool& value) const;
  void read_material_constants();
  std::vector<double> material_constant(const char* name, const char* symbol) const;
  void start_run(const LAMMPS_NS::NeighList& list);
  void announce_effects() const;
  void choose_loops();
  template <int... numbers>
  void choose_among(std::integer_sequence<int, numbers...> combinations);
  template <physics::Effects effects>
  void use_loops_of();
  template <bool spins>
  double gather(int first);
  template <physics::Effects effects>
  void flatten(LAMMPS_NS::PairGran& pair);
  void remember_places();
  template <physics::Effects effects>
  void find_near_pairs();
  void set_materials(physics::ContactBatch& batch, const physics::DiscPair* pairs, int count) const;
  void begin_and_end_contacts(physics::ContactBatch& batch, int first, int count, double dt);
  void observe(LAMMPS_NS::PairGran& pair, const physics::ContactBatch& batch, int lane, int first,
               bool addflag);
  [[noreturn]] void stop_at_coincident_centres(const physics::ContactBatch& batch,
                                               const physics::DiscPair* pairs) const;
  template <physics::Effects effects, bool observed>
  void loop(LAMMPS_NS::PairGran& pair, bool addflag);

  int64_t hash_;
  physics::Effects effects_;
  double impact_velocity_ = 0;  // [m/s] to be expected, for the time step; 0: not given
  bool run_started_ = false;
  std::vector<physics::ContactParameters> parameters_;  // of type i and type j at (i - 1) * types + j - 1
  PackedDiscs packed_;
  EndOfStepReaders readers_;
  std::unique_ptr<physics::ContactBatch> batch_ = std::make_unique<physics::ContactBatch>();
  // Since the neighbour list was built: its pairs, the first of each disc, and for laws with a spring the
  // engine's flags and histories of contacts, and which pairs touched in the last step.
  std::vector<physics::DiscPair> pairs_;
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
  bool forces_are_stale_ = false;  // the engine has not cleared its forces in this step
  bool springs_wait_ = false;      // the engine's histories are behind
  bool one_material_ = false;      // all pairs of types have the same constants
  Loop plain_loop_ = nullptr;
  Loop observed_loop_ = nullptr;
  bool predicted_ =
      false;  // the atoms carry velocities that were predicted for the instant of their positions
  ContactSchedule schedule_;
  bool recording_ = false;
  LAMMPS_NS::bigint recorded_step_ = -1;
  std::vector<AppliedContact> applied_;
};

/// The disc law that is active in this engine, or nullptr.
PairGranDisc* active_disc_law(LAMMPS_NS::LAMMPS& engine);

/// Makes the models known to the engine's factories; they are static and survive `clear`.
void register_disc_laws();

}  // namespace mikromakro::liggghts
