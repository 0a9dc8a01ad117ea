// SPDX-License-Identifier: GPL-2.0-or-later
// Registration with LAMMPS: the pair styles and, if a LAMMPS with the PLUGIN package loads this object, all
// other styles.
#include <type_traits>

#include "engine/engine_access.h"
#include "error.h"
#include "fix_disc_history.h"
#include "force.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "mikromakro_version.h"
#include "pair_disc.h"
#include "program/registration.h"
#include "version.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

template <physics::Normal normal>
Pair* make_pair_disc(LAMMPS* engine) {
  return new PairDisc(engine, normal);
}

template <int... normal>
std::map<std::string, Force::PairCreator> styles_of(std::integer_sequence<int, normal...> /*all*/) {
  return {{physics::name_of(static_cast<physics::Normal>(normal)),
           make_pair_disc<static_cast<physics::Normal>(normal)>}...};
}

const std::map<std::string, Force::PairCreator> laws =
    styles_of(std::make_integer_sequence<int, physics::normal_laws>{});
const std::map<std::string, FixCreator> springs = {{"NEIGH_HISTORY/DISC", make_fix<FixDiscHistory>}};

/// The package has no header from which the version could be checked at compile time.
void check_version(const LAMMPS& engine) {
  const std::string library = engine.version;
  if (library == LAMMPS_VERSION) return;
  engine.error->all(FLERR, "the disc styles were compiled for LAMMPS " LAMMPS_VERSION ", this is " + library);
}

}  // namespace

void register_disc_laws(LAMMPS& engine) {
  check_version(engine);
  for (const auto& [name, creator] : laws) (*engine.force->pair_map)[name] = creator;
  for (const auto& [name, creator] : springs) fix_styles(*engine.modify)[name] = creator;
}

}  // namespace mikromakro::styles

/// Called by the command `plugin load`. The engine keeps the names and calls the creators until it unloads
/// the styles, in this order: pair styles before their contact history fix.
extern "C" void lammpsplugin_init(void* engine, void* handle, void* register_style) {
  using namespace mikromakro::styles;
  check_version(*static_cast<LAMMPS_NS::LAMMPS*>(engine));
  const auto give = [&](const char* kind, const auto& styles) {
    for (const auto& [name, creator] : styles) {
      lammpsplugin_t style{};
      style.version = LAMMPS_VERSION;
      style.style = kind;
      style.name = style.info = name.c_str();
      style.author = "mikromakro " MIKROMAKRO_VERSION;
      // The engine casts it back according to the kind of style.
      if constexpr (std::is_invocable_v<decltype(creator), LAMMPS_NS::LAMMPS*>) {
        style.creator.v1 = reinterpret_cast<lammpsplugin_factory1*>(creator);
      } else {
        style.creator.v2 = reinterpret_cast<lammpsplugin_factory2*>(creator);
      }
      style.handle = handle;
      reinterpret_cast<lammpsplugin_regfunc>(register_style)(&style, engine);
    }
  };
  give("pair", laws);
  give("fix", springs);
  give("fix", disc_fixes);
  give("compute", disc_computes);
  give("command", disc_commands);
}
