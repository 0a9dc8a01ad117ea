// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/open_steps.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "force.h"
#include "law/fix_on_rows.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

bool may_act(const Fix& fix, int mask) {
  const auto* on_rows = dynamic_cast<const FixOnRows*>(&fix);
  return leaves_discs_alone(fix, on_rows ? mask & ~on_rows->calls_on_rows() : mask);
}

/// Bonded and long-range forces, which the engine adds after those of the pair style.
bool others_add_forces(const Force& force) {
  return force.bond || force.angle || force.dihedral || force.improper || force.kspace;
}

}  // namespace

bool steps_may_be_open(LAMMPS& engine, const Fix& integrator) {
  constexpr int run = 1;  // not a minimisation
  const Update& update = *engine.update;
  if (update.whichflag != run || std::strcmp(update.integrate_style, "verlet") != 0) return false;
  if (others_add_forces(*engine.force)) return false;
  const Modify& modify = *engine.modify;
  for (Fix* fix : fixes(modify))
    if (fix != &integrator && !may_act(*fix, mask_of(modify, fix))) return false;
  return true;
}

bool build_is_due(LAMMPS& engine) {
  const bigint step = engine.update->ntimestep;
  if (writes_restart_at(engine, step) || !engine.neighbor->dist_check) return true;
  const Modify& modify = *engine.modify;
  const auto all = fixes(modify);
  return std::any_of(all.begin(), all.end(), [step](const Fix* fix) {
    return fix->force_reneighbor && fix->next_reneighbor == step;
  });
}

void EndOfStepReaders::look_up(LAMMPS& engine) {
  const Modify& modify = *engine.modify;
  intervals_.clear();
  for (Fix* fix : fixes(modify))
    if (mask_of(modify, fix) & FixConst::END_OF_STEP) intervals_.push_back(fix->nevery);
}

bool EndOfStepReaders::any_at_present_step(LAMMPS& engine) const {
  const Update& update = *engine.update;
  const bigint step = update.ntimestep;
  if (update.setupflag || step == update.laststep || step == engine.output->next) return true;
  // A signal may end the run after any step.
  if (is_asked_to_stop()) return true;
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [step](int every) { return every <= 1 || step % every == 0; });
}

void SkippedWork::skip_list_check(LAMMPS& engine) {
  Neighbor& neighbor = *engine.neighbor;
  list_check_ = !neighbor.build_once;
  neighbor.build_once = 1;
  asks_for_lists_ = std::exchange(asks_for_lists(neighbor), 0);
}

void SkippedWork::skip_clearing(LAMMPS& engine) {
  int& not_cleared = forces_are_not_cleared(*engine.update->integrate);
  clearing_ = !not_cleared;
  not_cleared = 1;
}

void SkippedWork::restore(LAMMPS& engine) {
  Neighbor& neighbor = *engine.neighbor;
  if (list_check_) neighbor.build_once = 0;
  if (asks_for_lists_ != 0) asks_for_lists(neighbor) = std::exchange(asks_for_lists_, 0);
  if (clearing_) forces_are_not_cleared(*engine.update->integrate) = 0;
  forces_are_stale_ = clearing_;
  list_check_ = clearing_ = false;
}

bool SkippedWork::take_stale_forces() {
  return std::exchange(forces_are_stale_, false);
}

}  // namespace mikromakro::styles
