// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/effects_line.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "engine/engine_lists.h"
#include "fix.h"
#include "law/contact_rows.h"
#include "modify.h"

namespace mikromakro::styles {

using LAMMPS_NS::Fix;
using physics::Tangential;

namespace {

struct Effect {
  const char* name;
  bool simulated;
};

template <class Condition>
bool any_fix(const LAMMPS_NS::Modify& modify, Condition condition) {
  const auto all = fixes(modify);
  return std::any_of(all.begin(), all.end(), condition);
}

std::vector<Effect> effects(const physics::Effects& law, const LAMMPS_NS::Modify& modify) {
  const auto style = [](const char* name) {
    return [name](const Fix* fix) { return std::strcmp(fix->style, name) == 0; };
  };
  const auto wall = [](const Fix* fix) {
    const auto* source = dynamic_cast<const WallContactSource*>(fix);
    return source && !source->wall_kinds().empty();
  };
  std::vector<Effect> all = {
      {with_law(law.normal, [](auto of) { return of.effect; }), true},
      {"normal dashpot", law.normal_dashpot},
      {with_law(law.tangential, [](auto of) { return of.effect; }), law.tangential != Tangential::none},
      {"tangential dashpot", law.tangential == Tangential::damped_spring},
      {"cut-off of attraction", law.no_attraction},
      {"bottom friction", any_fix(modify, style("bottom/friction"))},
      {"gravity", any_fix(modify, style("gravity"))},
      {"smooth walls", any_fix(modify, wall)}};
  // Mentioned only if present.
  if (has_engine_walls(modify)) all.push_back({engine_walls, true});
  return all;
}

}  // namespace

bool has_engine_walls(const LAMMPS_NS::Modify& modify) {
  return any_fix(modify, [](const Fix* fix) {
    return std::strncmp(fix->style, "wall", 4) == 0 && !dynamic_cast<const WallContactSource*>(fix);
  });
}

std::vector<std::string> simulated_effects(const physics::Effects& law, const LAMMPS_NS::Modify& modify) {
  std::vector<std::string> names;
  for (const auto& [name, is_simulated] : effects(law, modify))
    if (is_simulated) names.emplace_back(name);
  return names;
}

std::string effects_line(const physics::Effects& law, const LAMMPS_NS::Modify& modify,
                         bool predicted_velocities) {
  std::string simulated, missing;
  for (const auto& [name, is_simulated] : effects(law, modify)) {
    std::string& list = is_simulated ? simulated : missing;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return "Effects simulated: " + simulated + "; not simulated: " + (missing.empty() ? "none" : missing) +
         "; dashpots see " + (predicted_velocities ? "predicted" : "half-step") + " velocities";
}

}  // namespace mikromakro::styles
