// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/run_record.h"

#include <utility>

#include "atom.h"
#include "engine/engine_access.h"
#include "io/snapshot/snapshot_layout.h"
#include "law/disc_law.h"
#include "law/effects_line.h"
#include "modify.h"
#include "update.h"

namespace mikromakro::styles {

SnapshotParameters run_record(LAMMPS_NS::LAMMPS& engine, const std::string& group, double height) {
  const DiscLaw& law_of_run = *active_disc_law(engine);
  SnapshotParameters record;
  record.engine = engine_name(engine);
  record.words = {{"units", {engine.update->unit_style}},
                  {"group", {group}},
                  {"effects", simulated_effects(law_of_run.effects(), *engine.modify)}};
  std::string law;
  for (const std::string& effect : simulated_effects(law_of_run.effects(), *engine.modify))
    law += (law.empty() ? "" : ", ") + effect;
  record.words.push_back({snapshot::law, {law}});
  if (has_engine_walls(*engine.modify)) record.words.push_back({snapshot::unrecorded_walls, {engine_walls}});
  if (height > 0) record.numbers.push_back({"height", "m", {1}, {height}});
  const auto types = static_cast<unsigned long long>(engine.atom->ntypes);
  for (auto& [name, unit, values] : law_of_run.given_constants())
    record.numbers.push_back({name, unit, {types, types}, std::move(values)});
  return record;
}

}  // namespace mikromakro::styles
