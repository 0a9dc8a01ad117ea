// SPDX-License-Identifier: GPL-2.0-or-later
// Material constants, and registration with the engine's factories.
#include <string>
#include <utility>

#include "atom.h"
#include "contact_models.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "fix_property_global.h"
#include "force.h"
#include "model_names.h"
#include "modify.h"
#include "pair_gran_disc.h"
#include "pair_gran_proxy.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Tangential;

std::vector<double> PairGranDisc::material_constant(const char* name, const char* symbol) const {
  const int types = atom->ntypes;
  auto* fix = dynamic_cast<FixPropertyGlobal*>(modify->find_fix_property(
      name, "property/global", "peratomtypepair", types, types, "pair_style gran", false));
  if (!fix) {
    fail(std::string("needs the material constant ") + symbol + "; expected 'fix ID all property/global " +
         name + " peratomtypepair " + std::to_string(types) + " ...' with one value for each pair of types");
  }
  std::vector<double> values;
  for (int i = 0; i < types; ++i) {
    for (int j = 0; j < types; ++j) {
      values.push_back(fix->compute_array(i, j));
      if (!(values.back() >= 0)) {
        fail(std::string("property/global ") + name + ": expected values >= 0, got " +
             text_of(values.back()));
      }
    }
  }
  return values;
}

std::vector<physics::ContactParameters> PairGranDisc::read_material_constants() const {
  const auto tangential = effects().tangential;
  const bool damped = tangential == Tangential::viscous_coulomb || tangential == Tangential::damped_spring;
  std::vector<physics::ContactParameters> parameters(static_cast<std::size_t>(atom->ntypes) * atom->ntypes);
  const auto store = [&](double physics::ContactParameters::*member, const char* name, const char* symbol) {
    const auto values = material_constant(name, symbol);
    for (std::size_t k = 0; k < values.size(); ++k) parameters[k].*member = values[k];
  };
  using P = physics::ContactParameters;
  const bool hertz = effects().normal == physics::Normal::hertz;
  store(&P::normal_stiffness, "kn", hertz ? "k_n [N/m^2]" : "k_n [N/m]");
  if (effects().normal_dashpot) store(&P::normal_damping, "gamman_abs", "gamma_n [kg/s]");
  if (tangential != Tangential::none) store(&P::friction, "coefficientFriction", "mu [-]");
  if (effects().spring()) store(&P::tangential_stiffness, "kt", "k_t [N/m]");
  if (damped) store(&P::tangential_damping, "gammat_abs", "gamma_t [kg/s]");
  for (const auto& p : parameters) {
    if (p.normal_stiffness == 0) fail("property/global kn: expected > 0, got 0");
    if (effects().spring() && p.tangential_stiffness == 0) {
      fail(
          "property/global kt: expected > 0, got 0; 'tangential disc/viscous' or 'tangential off' need no "
          "spring");
    }
  }
  return parameters;
}

std::vector<MaterialConstant> PairGranDisc::given_constants() const {
  const bool hertz = effects().normal == physics::Normal::hertz;
  const std::vector<std::pair<const char*, const char*>> all = {{"kn", hertz ? "N/m^2" : "N/m"},
                                                                {"gamman_abs", "kg/s"},
                                                                {"kt", "N/m"},
                                                                {"gammat_abs", "kg/s"},
                                                                {"coefficientFriction", ""}};
  const int types = atom->ntypes;
  std::vector<MaterialConstant> given;
  for (const auto& [name, unit] : all) {
    auto* fix = dynamic_cast<FixPropertyGlobal*>(modify->find_fix_property(
        name, "property/global", "peratomtypepair", types, types, "snapshot/disc", false));
    if (!fix) continue;
    given.push_back({name, unit, {}});
    for (int i = 0; i < types; ++i)
      for (int j = 0; j < types; ++j) given.back().values.push_back(fix->compute_array(i, j));
  }
  return given;
}

namespace {

using Implementation = LIGGGHTS::PairStyles::IGranularPairStyle;

// The implementation in the engine's proxy is private. Access: see engine_access.cpp.
struct ProxyImplementation {
  using Type = Implementation* PairGranProxy::*;
  friend Type member(ProxyImplementation);
};
template <class Tag, typename Tag::Type Member>
struct Grant {
  friend typename Tag::Type member(Tag /*tag*/) { return Member; }
};
template struct Grant<ProxyImplementation, &PairGranProxy::impl>;

Implementation* create_disc_law(LAMMPS* engine, PairGran* parent, int64_t hash) {
  return new PairGranDisc(engine, parent, hash);
}

}  // namespace

DiscLaw* active_disc_law(LAMMPS& engine) {
  auto* proxy = dynamic_cast<PairGranProxy*>(engine.force->pair);
  return proxy ? dynamic_cast<DiscLaw*>(proxy->*member(ProxyImplementation{})) : nullptr;
}

const char* const disc_pair_style = "pair_style gran model disc/linear ...";
const char* const law_styles =
    "Pair style gran: model disc/linear disc/hertz, tangential off disc/viscous disc/cundall_strack";

void register_disc_laws(LAMMPS& /*engine*/) {
  using LIGGGHTS::Utils::generate_gran_hashcode;
  namespace models = LIGGGHTS::ContactModels;
  static bool done = false;
  if (done) return;
  done = true;
  watch_model_names();
  auto& names = models::Factory::instance();
  names.addNormalModel("disc/linear", normal_model_linear);
  names.addNormalModel("disc/hertz", normal_model_hertz);
  names.addTangentialModel("disc/viscous", tangential_model_viscous);
  names.addTangentialModel("disc/cundall_strack", tangential_model_cundall_strack);
  for (const int normal : {normal_model_linear, normal_model_hertz}) {
    for (const int tangential : {static_cast<int>(models::TANGENTIAL_OFF), tangential_model_viscous,
                                 tangential_model_cundall_strack}) {
      const auto hash = generate_gran_hashcode(normal, tangential, models::COHESION_OFF, models::ROLLING_OFF,
                                               models::SURFACE_DEFAULT);
      LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", static_cast<int>(hash), create_disc_law);
    }
  }
}

}  // namespace mikromakro::styles
