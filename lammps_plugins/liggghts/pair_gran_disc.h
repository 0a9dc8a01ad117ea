// pair_style gran model disc/linear tangential off|disc/viscous|disc/cundall_strack: the adapter between
// LIGGGHTS and the contact law of physics/contact_law.h. It parses the settings, fetches the material
// constants, loops over the pairs of the engine's neighbour list in two dimensions and adds forces and
// torques; the arithmetic of the law is not here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "granular_pair_style.h"
#include "physics/contact_law.h"
#include "pointers.h"

namespace mikromakro::liggghts {

/// Ids under which the factories of LIGGGHTS know our models: 6 bits; the engine's own are below 32.
inline constexpr int normal_model_linear = 32;
inline constexpr int tangential_model_viscous = 32;
inline constexpr int tangential_model_cundall_strack = 33;

/// One contact as it acted in the last force evaluation; signs as in physics/contact_law.h.
struct AppliedContact {
  int i, j;  // local indices; i is owned, j may be a ghost
  double n_x, n_y, overlap;
  physics::ContactForce force;
  double v_n, v_t;
};

/// What the pair loop reads of a disc, and what it adds up for it.
struct Place {
  double x, y, radius;
  int type;  // from 0
};
struct Motion {
  double v_x, v_y, omega;
};
struct Load {
  double f_x, f_y, torque;
};

enum class Touch : int { no, first, yes };

/// A pair of the engine's neighbour list; flag and history are the engine's, so that its fixes find them
/// there.
struct NeighbourPair {
  int i, j;
  Touch touch;
  int* flag;
  double* history;
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
  double stressStrainExponent() override { return 1.0; }
  int64_t hashcode() override { return hash_; }
  bool contact_match(const std::string kind, const std::string model) override;

  /// The contacts of the force evaluation of this step; nullptr where the step was not recorded.
  const std::vector<AppliedContact>* applied_contacts() const;
  physics::Effects effects() const { return effects_; }

 private:
  using Loop = void (PairGranDisc::*)(LAMMPS_NS::PairGran&, bool addflag);
  struct Neighbours;

  void require_two_dimensions() const;
  void read_material_constants();
  std::vector<double> material_constant(const char* name, const char* symbol) const;
  void check_time_step() const;
  bool recording_due() const;
  double slip_of(const physics::ContactState& state, bool touched, double& slip_rate) const;
  void choose_loops();
  void gather();
  void scatter() const;
  template <physics::Effects effects>
  void flatten(LAMMPS_NS::PairGran& pair);
  template <physics::Effects effects>
  std::size_t find_contacts();
  template <physics::Effects effects>
  void use_loops_of();
  template <physics::Effects effects, bool observed>
  void loop(LAMMPS_NS::PairGran& pair, bool addflag);
  template <physics::Effects effects>
  void observe(LAMMPS_NS::PairGran& pair, const AppliedContact& contact, double* history, bool addflag);
  [[noreturn]] void stop_at_coincident_centres(int i, int j) const;

  int64_t hash_;
  physics::Effects effects_;
  std::vector<physics::ContactParameters> parameters_;  // of type i and type j at (i - 1) * types + j - 1
  // Of this step: owned and ghost discs, the loads on them, the indices of the pairs that touch.
  std::vector<Place> places_;
  std::vector<Motion> motions_;
  std::vector<Load> loads_;
  std::vector<int> touching_;
  std::vector<NeighbourPair> pairs_;  // since the neighbour list was built
  Loop plain_loop_ = nullptr;
  Loop observed_loop_ = nullptr;
  bool predicted_ =
      false;  // the atoms carry velocities that were predicted for the instant of their positions
  bool recorder_defined_ = false;
  bool recording_ = false;
  LAMMPS_NS::bigint recorded_step_ = -1;
  std::vector<AppliedContact> applied_;
};

/// The disc law that is active in this engine, or nullptr.
PairGranDisc* active_disc_law(LAMMPS_NS::LAMMPS& engine);

/// Makes the models known to the engine's factories; they are static and survive `clear`.
void register_disc_laws();

}  // namespace mikromakro::liggghts
