// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/packed_discs.h"

#include <algorithm>
#include <cstring>

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

bool may_stay_open(LAMMPS& engine, const Fix& integrator) {
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

}  // namespace mikromakro::styles
