// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style gran model disc/linear|disc/hertz tangential off|disc/viscous|disc/cundall_strack: the disc law
// for LIGGGHTS. Parses the settings, fetches the material constants from `fix property/global` and supplies
// the engine's pairs and contact history.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "granular_pair_style.h"
#include "law/disc_law.h"

namespace mikromakro::styles {

/// Ids of our models in the factories of LIGGGHTS: 6 bits; the engine's own are below 32.
constexpr int model_of(physics::Normal normal) {
  return 32 + static_cast<int>(normal);
}
/// "off" is the engine's own.
constexpr int model_of(physics::Tangential tangential) {
  return tangential == physics::Tangential::none ? 0 : 31 + static_cast<int>(tangential);
}

class PairGranDisc : public LIGGGHTS::PairStyles::IGranularPairStyle, public DiscLaw {
 public:
  PairGranDisc(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::PairGran* parent, int64_t hash);

  void settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* history) override;
  void init_granular() override;
  void write_restart_settings(FILE* file) override;
  void read_restart_settings(FILE* file, int64_t hash) override;
  void compute_force(LAMMPS_NS::PairGran* pair, int eflag, int vflag, int addflag) override;

  int get_history_offset(const std::string name) override;
  double stressStrainExponent() override {
    return physics::with_law(effects().normal, [](auto law) { return law.exponent; });
  }
  int64_t hashcode() override { return hash_; }
  bool contact_match(const std::string kind, const std::string model) override;

  std::string style() const override;
  std::vector<MaterialConstant> given_constants() const override;
  void copy_histories_to_atoms() override;

 protected:
  ContactHistory contact_history() override;
  void tally(const TalliedContact& contact) override;

 private:
  MaterialTable read_material_constants() const;
  void discard_foreign_springs();
  std::vector<double> material_constant(const ConstantOfLaw& constant) const;

  int64_t hash_;
  LAMMPS_NS::PairGran* pair_ = nullptr;  // during an evaluation
  bool adds_to_compute_ = false;         // during an evaluation: for compute pair/gran/local
};

}  // namespace mikromakro::styles
