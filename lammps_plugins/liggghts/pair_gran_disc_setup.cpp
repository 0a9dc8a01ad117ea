// Material constants, the check of the time step, and the entry into the engine's factories.
#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "atom.h"
#include "comm.h"
#include "contact_models.h"
#include "error.h"
#include "fix_property_global.h"
#include "force.h"
#include "modify.h"
#include "pair_gran_disc.h"
#include "pair_gran_proxy.h"
#include "physics/contact_duration.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::Tangential;

namespace {

std::string shortest(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Whether a fix that integrates the equations of motion moves the atom; walls are carried, and count as
/// infinitely heavy in a contact.
int integrated_groups(const Modify& modify) {
  int bits = 0;
  for (int k = 0; k < modify.nfix; ++k) {
    if (std::strncmp(modify.fix[k]->style, "nve", 3) == 0) bits |= modify.fix[k]->groupbit;
  }
  return bits;
}

/// Least mass of the discs of each type that move freely [kg], and whether the type has carried ones; over
/// all ranks.
struct TypeMasses {
  std::vector<double> lightest;
  std::vector<int> carried;
};

TypeMasses masses_by_type(const Atom& atom, int integrated, MPI_Comm world) {
  TypeMasses masses{std::vector<double>(atom.ntypes, std::numeric_limits<double>::infinity()),
                    std::vector<int>(atom.ntypes, 0)};
  for (int i = 0; i < atom.nlocal; ++i) {
    const int t = atom.type[i] - 1;
    if (atom.mask[i] & integrated) {
      masses.lightest[t] = std::min(masses.lightest[t], atom.rmass[i]);
    } else {
      masses.carried[t] = 1;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, masses.lightest.data(), atom.ntypes, MPI_DOUBLE, MPI_MIN, world);
  MPI_Allreduce(MPI_IN_PLACE, masses.carried.data(), atom.ntypes, MPI_INT, MPI_MAX, world);
  return masses;
}

/// Shortest contact duration of any pair of types that can meet [s]; infinite where nothing moves.
double shortest_contact(const TypeMasses& masses, const std::vector<physics::ContactParameters>& parameters) {
  const std::size_t types = masses.lightest.size();
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < types; ++i) {
    const double m_i = masses.lightest[i];
    if (!std::isfinite(m_i)) continue;
    for (std::size_t j = 0; j < types; ++j) {
      const auto& p = parameters[i * types + j];
      const double m_j = masses.lightest[j];
      if (std::isfinite(m_j)) {
        shortest = std::min(shortest, physics::contact_duration(p.normal_stiffness, p.normal_damping,
                                                                physics::reduced_mass(m_i, m_j)));
      }
      if (masses.carried[j]) {
        shortest = std::min(shortest, physics::contact_duration(p.normal_stiffness, p.normal_damping, m_i));
      }
    }
  }
  return shortest;
}

}  // namespace

std::vector<double> PairGranDisc::material_constant(const char* name, const char* symbol) const {
  const int types = atom->ntypes;
  auto* fix = dynamic_cast<FixPropertyGlobal*>(modify->find_fix_property(
      name, "property/global", "peratomtypepair", types, types, "pair_style gran", false));
  if (!fix) {
    const std::string text = std::string("pair_style gran model disc/linear: needs the material constant ") +
                             symbol + "; expected 'fix ID all property/global " + name + " peratomtypepair " +
                             std::to_string(types) + " ...' with one value for each pair of types";
    error->all(FLERR, text.c_str());
  }
  std::vector<double> values;
  for (int i = 0; i < types; ++i) {
    for (int j = 0; j < types; ++j) {
      values.push_back(fix->compute_array(i, j));
      if (!(values.back() >= 0)) {
        error->all(FLERR, (std::string("pair_style gran model disc/linear: property/global ") + name +
                           ": expected values >= 0, got " + shortest(values.back()))
                              .c_str());
      }
    }
  }
  return values;
}

void PairGranDisc::read_material_constants() {
  const auto tangential = effects_.tangential;
  const bool damped = tangential == Tangential::viscous_coulomb || tangential == Tangential::damped_spring;
  parameters_.assign(static_cast<std::size_t>(atom->ntypes) * atom->ntypes, {});
  const auto store = [&](double physics::ContactParameters::*member, const char* name, const char* symbol) {
    const auto values = material_constant(name, symbol);
    for (std::size_t k = 0; k < values.size(); ++k) parameters_[k].*member = values[k];
  };
  using P = physics::ContactParameters;
  store(&P::normal_stiffness, "kn", "k_n [N/m]");
  store(&P::normal_damping, "gamman_abs", "gamma_n [kg/s]");
  if (tangential != Tangential::none) store(&P::friction, "coefficientFriction", "mu [-]");
  if (effects_.spring()) store(&P::tangential_stiffness, "kt", "k_t [N/m]");
  if (damped) store(&P::tangential_damping, "gammat_abs", "gamma_t [kg/s]");
  one_material_ = std::all_of(parameters_.begin(), parameters_.end(),
                              [&](const P& p) { return p == parameters_.front(); });
  for (const auto& p : parameters_) {
    if (p.normal_stiffness == 0)
      error->all(FLERR, "pair_style gran model disc/linear: property/global kn: expected > 0, got 0");
    if (effects_.spring() && p.tangential_stiffness == 0) {
      error->all(FLERR,
                 "pair_style gran model disc/linear: property/global kt: expected > 0, got 0; "
                 "'tangential disc/viscous' or 'tangential off' need no spring");
    }
  }
}

void PairGranDisc::check_time_step() const {
  const int integrated = integrated_groups(*modify);
  const double t_c = shortest_contact(masses_by_type(*atom, integrated, world), parameters_);
  if (!std::isfinite(t_c)) return;
  const std::string dt = shortest(update->dt), duration = shortest(t_c);
  if (update->dt > t_c / physics::least_steps_per_contact) {
    error->all(FLERR, ("pair_style gran model disc/linear: time step " + dt +
                       " s is above a quarter of the shortest contact (t_c = " + duration +
                       " s), the integration would be unstable; expected 'timestep " +
                       shortest(t_c / physics::steps_per_contact) + "' (t_c/50) or less")
                          .c_str());
  }
  if (comm->me == 0 && update->dt > t_c / physics::steps_per_contact * (1 + 1e-9)) {
    error->warning(FLERR, ("pair_style gran model disc/linear: time step " + dt +
                           " s is above t_c/50 of the shortest contact (t_c = " + duration +
                           " s); 'timestep " + shortest(t_c / physics::steps_per_contact) + "' would do")
                              .c_str());
  }
}

namespace {

using Implementation = LIGGGHTS::PairStyles::IGranularPairStyle;

// The engine's proxy keeps its implementation private; see style_maps.h for the way in.
struct ProxyImplementation {
  using Type = Implementation* PairGranProxy::*;
  friend Type member(ProxyImplementation tag);
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

PairGranDisc* active_disc_law(LAMMPS& engine) {
  auto* proxy = dynamic_cast<PairGranProxy*>(engine.force->pair);
  return proxy ? dynamic_cast<PairGranDisc*>(proxy->*member(ProxyImplementation{})) : nullptr;
}

void register_disc_laws() {
  using LIGGGHTS::Utils::generate_gran_hashcode;
  namespace models = LIGGGHTS::ContactModels;
  static bool done = false;
  if (done) return;
  done = true;
  auto& names = models::Factory::instance();
  names.addNormalModel("disc/linear", normal_model_linear);
  names.addTangentialModel("disc/viscous", tangential_model_viscous);
  names.addTangentialModel("disc/cundall_strack", tangential_model_cundall_strack);
  for (const int tangential : {static_cast<int>(models::TANGENTIAL_OFF), tangential_model_viscous,
                               tangential_model_cundall_strack}) {
    const auto hash = generate_gran_hashcode(normal_model_linear, tangential, models::COHESION_OFF,
                                             models::ROLLING_OFF, models::SURFACE_DEFAULT);
    LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", static_cast<int>(hash), create_disc_law);
  }
}

}  // namespace mikromakro::liggghts
