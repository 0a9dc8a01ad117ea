// SPDX-License-Identifier: GPL-2.0-or-later
// Material constants, and registration with the engine's factories.
#include <string>

#include "atom.h"
#include "contact_models.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/private_member.h"
#include "fix_property_global.h"
#include "force.h"
#include "law/law_names.h"
#include "model_names.h"
#include "modify.h"
#include "pair_gran_disc.h"
#include "pair_gran_proxy.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Tangential;

std::vector<double> PairGranDisc::material_constant(const ConstantOfLaw& constant) const {
  const int types = atom->ntypes;
  const std::string name = constant.name;
  auto* fix = dynamic_cast<FixPropertyGlobal*>(modify->find_fix_property(
      constant.name, "property/global", "peratomtypepair", types, types, "pair_style gran", false));
  if (!fix) {
    fail("needs the material constant " + label_of(constant, effects().normal) +
         "; expected 'fix ID all property/global " + name + " peratomtypepair " + std::to_string(types) +
         " ...' with one value for each pair of types");
  }
  std::vector<double> values;
  for (int i = 0; i < types; ++i) {
    for (int j = 0; j < types; ++j) {
      values.push_back(fix->compute_array(i, j));
      if (!(values.back() >= 0)) {
        fail("property/global " + name + ": expected values >= 0, got " + text_of(values.back()));
      }
    }
  }
  return values;
}

MaterialTable PairGranDisc::read_material_constants() const {
  MaterialTable materials(atom->ntypes);
  for (const ConstantOfLaw& constant : constants_of_law) {
    if (!is_needed(constant, effects())) continue;
    const auto values = material_constant(constant);
    for (std::size_t k = 0; k < values.size(); ++k) materials.values()[k].*constant.member = values[k];
  }
  for (const auto& p : materials.values()) {
    if (p.normal_stiffness == 0) fail("property/global kn: expected > 0, got 0");
    if (effects().spring() && p.tangential_stiffness == 0) {
      fail(
          "property/global kt: expected > 0, got 0; 'tangential disc/viscous' or 'tangential off' need no "
          "spring");
    }
  }
  return materials;
}

std::vector<MaterialConstant> PairGranDisc::given_constants() const {
  const int types = atom->ntypes;
  std::vector<MaterialConstant> given;
  for (const ConstantOfLaw& constant : constants_of_law) {
    auto* fix = dynamic_cast<FixPropertyGlobal*>(modify->find_fix_property(
        constant.name, "property/global", "peratomtypepair", types, types, "snapshot/disc", false));
    if (!fix) continue;
    given.push_back({constant.name, unit_of(constant, effects().normal), {}});
    for (int i = 0; i < types; ++i)
      for (int j = 0; j < types; ++j) given.back().values.push_back(fix->compute_array(i, j));
  }
  return given;
}

// The implementation in the engine's proxy is private.
struct ProxyImplementation {
  friend auto member(ProxyImplementation);
};

template struct PrivateMember<ProxyImplementation, &PairGranProxy::impl>;

namespace {

using Implementation = LIGGGHTS::PairStyles::IGranularPairStyle;

Implementation* create_disc_law(LAMMPS* engine, PairGran* parent, int64_t hash) {
  return new PairGranDisc(engine, parent, hash);
}

}  // namespace

DiscLaw* active_disc_law(LAMMPS& engine) {
  auto* proxy = dynamic_cast<PairGranProxy*>(engine.force->pair);
  return proxy ? dynamic_cast<DiscLaw*>(proxy->*member(ProxyImplementation{})) : nullptr;
}

const char* const disc_pair_style = "pair_style gran model disc/linear ...";
const char* const law_styles[] = {"Pair style gran: model", "tangential"};

void register_disc_laws(LAMMPS& /*engine*/) {
  using LIGGGHTS::Utils::generate_gran_hashcode;
  namespace models = LIGGGHTS::ContactModels;
  static bool done = false;
  if (done) return;
  done = true;
  watch_model_names();
  auto& names = models::Factory::instance();
  for (const auto normal : physics::all_normal_laws())
    names.addNormalModel(physics::name_of(normal), model_of(normal));
  for (const auto& name : tangential_names()) {
    const auto tangential = *tangential_named(name);
    const int model = model_of(tangential);
    if (tangential != Tangential::none) names.addTangentialModel(name, model);
    for (const auto normal : physics::all_normal_laws()) {
      const auto hash = generate_gran_hashcode(model_of(normal), model, models::COHESION_OFF,
                                               models::ROLLING_OFF, models::SURFACE_DEFAULT);
      LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", static_cast<int>(hash), create_disc_law);
    }
  }
}

}  // namespace mikromakro::styles
