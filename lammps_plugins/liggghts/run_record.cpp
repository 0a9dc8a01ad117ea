#include "run_record.h"

#include <utility>
#include <vector>

#include "atom.h"
#include "effects_line.h"
#include "fix_property_global.h"
#include "modify.h"
#include "pair_gran_disc.h"
#include "universe.h"
#include "update.h"

namespace mikromakro::liggghts {

using LAMMPS_NS::FixPropertyGlobal;

namespace {

// The constants of our laws, each a table over pairs of types; that of the normal force depends on the law.
std::vector<std::pair<const char*, const char*>> constants_of(const physics::Effects& law) {
  return {{"kn", law.normal == physics::Normal::hertz ? "N/m^2" : "N/m"},
          {"gamman_abs", "kg/s"},
          {"kt", "N/m"},
          {"gammat_abs", "kg/s"},
          {"coefficientFriction", ""}};
}

}  // namespace

SnapshotParameters run_record(LAMMPS_NS::LAMMPS& engine, double height) {
  const physics::Effects law = active_disc_law(engine)->effects();
  SnapshotParameters record;
  record.engine = engine.universe->version;
  record.words = {{"units", {engine.update->unit_style}},
                  {"effects", simulated_effects(law, *engine.modify)}};
  if (height > 0) record.numbers.push_back({"height", "m", {1}, {height}});
  const int types = engine.atom->ntypes;
  for (const auto& [name, unit] : constants_of(law)) {
    auto* fix = dynamic_cast<FixPropertyGlobal*>(engine.modify->find_fix_property(
        name, "property/global", "peratomtypepair", types, types, "snapshot/disc", false));
    if (!fix) continue;
    const auto size = static_cast<unsigned long long>(types);
    record.numbers.push_back({name, unit, {size, size}, {}});
    for (int i = 0; i < types; ++i)
      for (int j = 0; j < types; ++j) record.numbers.back().values.push_back(fix->compute_array(i, j));
  }
  return record;
}

}  // namespace mikromakro::liggghts
