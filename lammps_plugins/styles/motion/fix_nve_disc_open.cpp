// SPDX-License-Identifier: GPL-2.0-or-later
// fix nve/disc: open steps (law/packed_discs.h), with fused half-kicks on the packed disc data.
#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "engine/processor_clones.h"
#include "law/disc_law.h"
#include "law/open_steps.h"
#include "motion/fix_nve_disc.h"
#include "update.h"

namespace mikromakro::styles {

using physics::Four;

/// At the first step that ends open: stores mid-step velocities, from which the next step
/// begins.
void FixNveDisc::store_half_steps() {
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double kick = update->dt / 2 / atom->rmass[i];
    half_steps_[i].values = Four{atom->v[i][0], atom->v[i][1], atom->omega[i][2], kick};
    spin_kicks_[i] = 2 * kick / (atom->radius[i] * atom->radius[i]);
  }
  half_steps_pending_ = true;
}

namespace {

struct OpenStep {
  const int* members;
  int count;
  double dt;
  Four* half_steps;
  const double* spin_kicks;
  physics::DiscRow* discs;
  physics::DiscLoad* loads;
  int next = 0;        // of the members
  double fastest = 0;  // largest squared velocity of the members moved so far
};

/// Moves the members with index below `before`: final half-kick of the previous step, first half-kick and
/// drift of this step, and the velocity predicted for its end. Same arithmetic as end_step() and
/// begin_step().
FOR_EACH_PROCESSOR void move_discs(OpenStep& step, int before) {
  const Four drift = {step.dt, step.dt, 0, 0};
  double fastest = step.fastest;
  int k = step.next;
  for (; k < step.count && step.members[k] < before; ++k) {
    const int i = step.members[k];
    auto& disc = step.discs[i];
    auto& load = step.loads[i];
    const double radius = disc.radius(), kick = step.half_steps[i][3];
    const Four dv =
        Four{kick, kick, step.spin_kicks[i], 0} * Four{load.f_x(), load.f_y(), load.torque(radius), 0};
    const Four half = step.half_steps[i] + dv + dv;
    step.half_steps[i] = half;
    disc.place += drift * half;
    const Four now = half + dv;
    disc.set_motion(now[0], now[1], now[2]);
    load = {};
    fastest = std::max(fastest, half[0] * half[0] + half[1] * half[1]);
  }
  step.next = k;
  step.fastest = fastest;
}

}  // namespace

/// As begin_step(), with fused half-kicks from the packed disc data.
void FixNveDisc::begin_fused_step() {
  if (!members_known_) find_members();
  static_assert(sizeof(OfDisc) == sizeof(Four));
  OpenStep step{members_.data(),
                static_cast<int>(members_.size()),
                update->dt,
                &half_steps_.data()->values,
                spin_kicks_.data(),
                shared_->packed.discs.data(),
                shared_->packed.loads.data()};
  law_->complete_step([&step](int before) { move_discs(step, before); });
  // Whether carried by a ring or immobile.
  for (const int i : others_) shared_->packed.loads[i] = {};
  shared_->packed.furthest = std::max(shared_->packed.furthest, std::sqrt(step.fastest) * step.dt);
  shared_->packed.step = update->ntimestep;
}

/// True if no disc on any rank can have moved beyond half the skin of the neighbour list. Also decides
/// whether the inner list is to be pruned, in the same step on all ranks, since a rank pruning alone would
/// keep the others waiting. The MPI_Allreduce costs as much as some hundred discs, so its result is reused
/// for up to four steps, less than a collision takes. Within these an elastic collision at most doubles the
/// largest speed, and discs released from rest, which move by 1, 3, 5, 7, 9 in equal steps, average six times
/// the first displacement over the last four. On a single rank the check is repeated in every step.
bool FixNveDisc::lists_stay_valid() {
  if (update->ntimestep < next_check_) return true;
  const PackedDiscs& packed = shared_->packed;
  int steps[] = {shared_->skin.steps_lists_stay_valid(packed),
                 shared_->skin.steps_inner_list_stays_valid(packed)};
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, steps, 2, MPI_INT, MPI_MIN, world);
  shared_->packed.prune_is_due = steps[1] == 0;
  next_check_ = update->ntimestep + std::clamp(std::min(steps[0], steps[1]), 1, comm->nprocs > 1 ? 4 : 1);
  return steps[0] > 0;
}

/// All discs have moved, and the engine is about to check whether neighbour lists must be rebuilt. If they
/// cannot be due, its search over all discs is skipped; if they may be, discs and tangential displacements
/// must be in its arrays. The clearing of forces is skipped too if nothing reads them.
void FixNveDisc::post_integrate() {
  if (!shared_ || !shared_->packed.open) return;
  if (!lists_stay_valid() || build_is_due(*lmp)) {
    shared_->packed.unpack_owned(*atom, law_->rows_have_spins());
    shared_->lists.write_history();
  } else {
    const bool spins = law_->rows_have_spins();
    for (const int i : with_ghosts_) shared_->packed.unpack(*atom, i, spins);
    shared_->skipped.skip_list_check(*lmp);
  }
  if (law_->step_may_end_open()) shared_->skipped.skip_clearing(*lmp);
}

}  // namespace mikromakro::styles
