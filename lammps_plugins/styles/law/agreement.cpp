// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/agreement.h"

#include <cmath>
#include <map>
#include <string>

#include "engine/arguments.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "fix.h"
#include "lammps.h"
#include "law/contact_rows.h"
#include "modify.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

std::string name_of(const Fix& fix) {
  return std::string("fix ") + fix.id + " (" + fix.style + ")";
}

void compare_heights(LAMMPS& engine) {
  constexpr double digits = 1e-6;
  const Fix* first = nullptr;
  double height = 0;
  for (const Fix* fix : fixes(*engine.modify)) {
    const auto* given = dynamic_cast<const KnowsHeight*>(fix);
    if (!given || given->given_height() == 0) continue;
    if (first && std::abs(given->given_height() - height) > digits * height)
      return warn(engine, name_of(*fix) + ": height " + text_of(given->given_height()) + " m, but " +
                              name_of(*first) + " has " + text_of(height) +
                              " m: their stresses are inconsistent");
    if (first) continue;
    first = fix;
    height = given->given_height();
  }
}

void compare_wall_ids(LAMMPS& engine) {
  std::map<int, const Fix*> of_id;
  for (const Fix* fix : fixes(*engine.modify)) {
    const auto* walls = dynamic_cast<const WallContactSource*>(fix);
    if (!walls) continue;
    for (const WallKind& wall : walls->wall_kinds()) {
      const auto [other, is_new] = of_id.emplace(wall.id, fix);
      if (is_new || other->second == fix) continue;
      return warn(engine, name_of(*other->second) + " and " + name_of(*fix) +
                              ": both have a wall with the id " + std::to_string(wall.id) +
                              " in contact rows, where they cannot be distinguished");
    }
  }
}

}  // namespace

void warn_of_disagreement(LAMMPS& engine) {
  compare_heights(engine);
  compare_wall_ids(engine);
}

}  // namespace mikromakro::styles
