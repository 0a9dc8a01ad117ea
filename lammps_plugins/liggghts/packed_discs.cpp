#include "packed_discs.h"

#include <algorithm>
#include <cstring>

#include "fix.h"
#include "fix_couette_2d.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "signal_handling.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;

namespace {

/// What a fix may do while the state is open: look at the end of a step, and stand by when discs change
/// their ranks, for which the velocities are put into the engine's arrays.
bool leaves_discs_alone(const Fix& fix, int mask) {
  using namespace FixConst;
  constexpr int harmless = END_OF_STEP | THERMO_ENERGY | POST_RUN | MIN_PRE_EXCHANGE | MIN_PRE_NEIGHBOR |
                           MIN_PRE_FORCE | MIN_POST_FORCE | MIN_ENERGY;
  if (dynamic_cast<const FixCouette2d*>(&fix))
    return (mask & ~(harmless | INITIAL_INTEGRATE | PRE_EXCHANGE)) == 0;
  const bool history = std::strcmp(fix.style, "contacthistory") == 0;
  return (mask & ~(harmless | (history ? PRE_EXCHANGE : 0))) == 0;
}

}  // namespace

bool may_stay_open(LAMMPS& engine, const Fix& integrator) {
  const Modify& modify = *engine.modify;
  if (std::strcmp(engine.update->integrate_style, "verlet") != 0) return false;
  for (int k = 0; k < modify.nfix; ++k) {
    if (modify.fix[k] != &integrator && !leaves_discs_alone(*modify.fix[k], modify.fmask[k])) return false;
  }
  return true;
}

bool build_is_due(LAMMPS& engine) {
  const bigint step = engine.update->ntimestep;
  if (engine.output->restart_requested(step) || !engine.neighbor->dist_check) return true;
  const Modify& modify = *engine.modify;
  return std::any_of(modify.fix, modify.fix + modify.nfix, [step](const Fix* fix) {
    return fix->force_reneighbor && fix->next_reneighbor == step;
  });
}

void EndOfStepReaders::look_up(LAMMPS& engine) {
  const Modify& modify = *engine.modify;
  intervals_.clear();
  for (int k = 0; k < modify.nfix; ++k) {
    if (modify.fmask[k] & FixConst::END_OF_STEP) intervals_.push_back(modify.fix[k]->nevery);
  }
}

bool EndOfStepReaders::any_at_present_step(LAMMPS& engine) const {
  const Update& update = *engine.update;
  const bigint step = update.ntimestep;
  if (update.setupflag || step == update.laststep || step == engine.output->next) return true;
  // A signal may end the run after any step.
  if (SignalHandler::request_quit || SignalHandler::request_write_restart) return true;
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [step](int every) { return every <= 1 || step % every == 0; });
}

}  // namespace mikromakro::liggghts
