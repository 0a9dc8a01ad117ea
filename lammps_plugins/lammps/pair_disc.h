// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style disc/linear|disc/hertz [tangential off|disc/viscous|disc/cundall_strack] [damping on|off]
//                        [tangential_damping on|off] [limitForce on|off]; disc/hertz: [impact_velocity V]
// pair_coeff I J kn K [gamman G] [kt K] [gammat G] [mu M]
//
// The disc law for LAMMPS. Without `tangential` there is no friction; damping is on by default, the other
// switches are off. Constants are those of docs/conventions.md: k_n (N/m; Hertz: N/m^2), gamma_n (kg/s), k_t
// (N/m), gamma_t (kg/s), mu; constants that the law does not use may be omitted. There is no mixing: each
// pair of types needs its pair_coeff (ranges and * as usual); a later one replaces an earlier one completely.
// Settings, constants and springs are stored in restart files.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "law/disc_law.h"
#include "pair.h"

namespace mikromakro::styles {

class FixDiscHistory;

template <class Pair>
concept transfers_by_type = requires(Pair& pair, double* history) {
  pair.transfer_history(history, history, 0, 0);
};

/// Contact history as seen from the partner disc. Newer LAMMPS also passes both types.
template <class Pair>
class WithHistory : public Pair {
 public:
  using Pair::Pair;
  void transfer_history(double* from, double* to) override { turn_history(from, to); }

 protected:
  virtual void turn_history(const double* from, double* to) = 0;
};

template <transfers_by_type Pair>
class WithHistory<Pair> : public Pair {
 public:
  using Pair::Pair;
  void transfer_history(double* from, double* to, int /*type_1*/, int /*type_2*/) override {
    turn_history(from, to);
  }

 protected:
  virtual void turn_history(const double* from, double* to) = 0;
};

class PairDisc : public WithHistory<LAMMPS_NS::Pair> {
 public:
  PairDisc(LAMMPS_NS::LAMMPS* engine, physics::Normal normal);
  ~PairDisc() override;
  PairDisc(const PairDisc&) = delete;
  PairDisc& operator=(const PairDisc&) = delete;

  void settings(int narg, char** arg) override;
  void coeff(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  void write_restart(FILE* file) override;
  void read_restart(FILE* file) override;
  double memory_usage() override;

  /// The contact of two discs as applied in this step, for compute pair/local and others: normal force on i
  /// over distance, elastic energy of the overlap (J), and in `svector` the tangential force on i (x, y, z)
  /// and its magnitude (N), as in the engine's granular styles. All 0 if the discs do not touch.
  double single(int i, int j, int type_i, int type_j, double distance_square, double factor_coulomb,
                double factor_lj, double& force_over_distance) override;

  DiscLaw& law() { return law_; }

 protected:
  void turn_history(const double* from, double* to) override;

 private:
  /// The disc law, with the engine's contact history.
  class Law : public DiscLaw {
   public:
    Law(PairDisc& pair, LAMMPS_NS::LAMMPS* engine, physics::Normal normal);
    std::string style() const override;
    std::vector<MaterialConstant> given_constants() const override;
    void copy_histories_to_atoms() override;
    void read(int narg, char** arg);

    using DiscLaw::begin_run;
    using DiscLaw::evaluate;
    using DiscLaw::fail;
    using DiscLaw::law_settings;
    using DiscLaw::require_two_dimensions;
    using DiscLaw::use_settings;

   protected:
    ContactHistory contact_history() override;
    void tally(const TalliedContact& contact) override;

   private:
    PairDisc& pair_;
    physics::Normal normal_;
  };

  /// Coefficients of a pair of types, in the order of constants_of_law.
  using Coefficients = std::array<std::optional<double>, constants_of_law.size()>;
  void allocate();
  physics::ContactParameters parameters(int i, int j) const;
  MaterialTable materials() const;
  void provide_history();
  void warn_of_foreign_springs() const;

  const AppliedContact* contact_of(int i, int j);
  double elastic_energy(const AppliedContact& contact) const;

  Law law_;
  std::map<std::pair<int, int>, const AppliedContact*> contacts_;  // of this step, by ordered pair (i, j)
  LAMMPS_NS::bigint contacts_step_ = -1;
  FixDiscHistory* history_ = nullptr;
  TypePairTable<Coefficients> coefficients_;  // of types i <= j
};

}  // namespace mikromakro::styles
