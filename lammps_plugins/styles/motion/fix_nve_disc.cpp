// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/fix_nve_disc.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <mpi.h>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/processor_clones.h"
#include "error.h"
#include "law/disc_law.h"
#include "law/open_steps.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Four;

FixNveDisc::FixNveDisc(LAMMPS* engine, int narg, char** arg)
    : FixOfEngine(engine, narg, arg), last_forces_(*engine) {
  time_integrate = 1;
  restart_global = restart_peratom = 1;
  has_values_of_atoms(size_of_half_step + size_of_prediction + LastForces::values);
  has_values_of_ghosts(size_for_ghosts);
  read_options(narg, arg);
  if (!stores_discs(*atom))
    error->all(FLERR, (std::string("fix nve/disc: needs 'atom_style ") + disc_atom_style + "'").c_str());
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

void FixNveDisc::read_options(int narg, char** arg) {
  Arguments arguments(*lmp, "fix nve/disc", narg, arg, 3);
  while (arguments.more()) {
    if (arguments.take_once("velocity")) {
      predicted_ = arguments.take("predicted");
      if (!predicted_ && !arguments.take("half_step"))
        arguments.unexpected("'predicted' or 'half_step' after 'velocity'");
    } else if (arguments.take_once("fused")) {
      fused_ = arguments.take("on");
      if (!fused_ && !arguments.take("off")) arguments.unexpected("'on' or 'off' after 'fused'");
    } else {
      arguments.unexpected("'velocity predicted', 'velocity half_step', 'fused on' or 'fused off'");
    }
  }
}

FixNveDisc::~FixNveDisc() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixNveDisc::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::POST_INTEGRATE | FixConst::PRE_EXCHANGE |
         FixConst::PRE_FORCE | FixConst::FINAL_INTEGRATE;
}

/// Checks the requirements of a run; a minimisation moves discs itself.
void FixNveDisc::check_run() const {
  if (domain->dimension != 2)
    error->all(FLERR, "fix nve/disc: discs live in two dimensions; put 'dimension 2' before the box");
  if (update->whichflag != 1) return;
  if (std::strncmp(update->integrate_style, "verlet", 6) != 0)
    stop(*lmp, "fix nve/disc", std::string("expected 'run_style verlet', got ") + update->integrate_style);
  if (!(update->dt > 0)) stop(*lmp, "fix nve/disc", "expected a time step > 0, got " + text_of(update->dt));
}

void FixNveDisc::init() {
  check_run();
  step_complete_ = half_steps_pending_ = false;
  prediction_ = Prediction::none;
  next_check_ = 0;
  law_ = active_disc_law(*lmp);
  packed_ = law_ ? &law_->packed_discs(*this) : nullptr;
  predicts_ = law_ && predicted_ && law_->velocities_predicted();
  if (packed_) packed_->may_stay_open = predicts_ && fused_ && steps_may_be_open(*lmp, *this);
}

/// The engine sorts and exchanges atoms before the first step.
void FixNveDisc::setup_pre_exchange() {
  members_known_ = false;
}

void FixNveDisc::initial_integrate(int /*vflag*/) {
  resume_last_run();
  if (packed_ && packed_->open) {
    begin_fused_step();
  } else {
    begin_step();
  }
}

void FixNveDisc::find_members() {
  members_.clear();
  others_.clear();
  for (int i = 0; i < atom->nlocal; ++i) (atom->mask[i] & groupbit ? members_ : others_).push_back(i);
  with_ghosts_ = atoms_with_ghosts(*comm, atom->nlocal);
  members_known_ = true;
}

void FixNveDisc::begin_step() {
  half_steps_pending_ = false;
  const double dt = update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (predicts_) predictions_[i].values = Four{0, 0, 0, 0};
    if (!(atom->mask[i] & groupbit)) continue;
    double *x = atom->x[i], *v = atom->v[i], *omega = atom->omega[i];
    const double kick = dt / 2 / atom->rmass[i];
    const double spin_kick = 2 * kick / (atom->radius[i] * atom->radius[i]);
    const double dv_x = kick * atom->f[i][0], dv_y = kick * atom->f[i][1],
                 domega = spin_kick * atom->torque[i][2];
    v[0] += dv_x;
    v[1] += dv_y;
    omega[2] += domega;
    x[0] += dt * v[0];
    x[1] += dt * v[1];
    if (predicts_) predictions_[i].values = Four{dv_x, dv_y, domega, 0};
  }
}

void FixNveDisc::send_to_ghosts() {
  if (half_steps_pending_) return;
  if (comm->nprocs > 1 || atom->nghost > 0) send_values_to_ghosts();
}

void FixNveDisc::pre_force(int /*vflag*/) {
  if (!predicts_ || half_steps_pending_) return;
  prediction_ = Prediction::differences;
}

void FixNveDisc::predict(std::vector<physics::DiscRow>& rows, int first) const {
  if (prediction_ == Prediction::none) return;
  const bool adds = prediction_ == Prediction::differences;
  const int count = static_cast<int>(rows.size());
  for (int i = first; i < count; ++i) {
    auto& motion = rows[i].motion;
    const Four& given = predictions_[i].values;
    const Four v = adds ? motion + given : given;
    rows[i].set_motion(v[0], v[1], v[2]);
  }
}

/// At the first step that ends in the open state: stores mid-step velocities, from which the next step
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
  OpenStep step{members_.data(),      static_cast<int>(members_.size()),
                update->dt,           &half_steps_.data()->values,
                spin_kicks_.data(),   packed_->discs.data(),
                packed_->loads.data()};
  law_->complete_step([&step](int before) { move_discs(step, before); });
  // Whether carried by a ring or immobile.
  for (const int i : others_) packed_->loads[i] = {};
  packed_->furthest = std::max(packed_->furthest, std::sqrt(step.fastest) * step.dt);
  packed_->step = update->ntimestep;
}

/// True if no disc on any rank can have moved beyond half the skin of the neighbour list. Also decides
/// whether the inner list is to be pruned, in the same step on all ranks, since a rank pruning alone would
/// keep the others waiting. The MPI_Allreduce costs as much as some hundred discs, so its result is reused
/// for up to four steps, less than a collision takes. Within these an elastic collision at most doubles the
/// largest speed, and discs released from rest, which move by 1, 3, 5, 7, 9 in equal steps, average six times
/// the first displacement over the last four. On a single rank the check is repeated in every step.
bool FixNveDisc::lists_stay_valid() {
  if (update->ntimestep < next_check_) return true;
  int steps[] = {law_->steps_lists_stay_valid(), law_->steps_inner_list_stays_valid()};
  if (comm->nprocs > 1) MPI_Allreduce(MPI_IN_PLACE, steps, 2, MPI_INT, MPI_MIN, world);
  packed_->prune_is_due = steps[1] == 0;
  next_check_ = update->ntimestep + std::clamp(std::min(steps[0], steps[1]), 1, comm->nprocs > 1 ? 4 : 1);
  return steps[0] > 0;
}

/// All discs have moved, and the engine is about to check whether neighbour lists must be rebuilt. If they
/// cannot be due, its search over all discs is skipped; if they may be, discs and tangential displacements
/// must be in its arrays. The clearing of forces is skipped too if nothing reads them.
void FixNveDisc::post_integrate() {
  if (!packed_ || !packed_->open) return;
  if (!lists_stay_valid() || build_is_due(*lmp)) {
    law_->write_discs_to_engine();
    law_->write_displacements_to_engine();
  } else {
    for (const int i : with_ghosts_) law_->write_disc_to_engine(i);
    law_->skipped_work(*this).skip_list_check(*lmp);
  }
  if (law_->step_may_end_open()) law_->skipped_work(*this).skip_clearing(*lmp);
}

/// Discs are about to change indices and ranks.
void FixNveDisc::pre_exchange() {
  members_known_ = false;
}

void FixNveDisc::final_integrate() {
  prediction_ = Prediction::none;
  if (!packed_ || !packed_->open) {
    end_step();
  } else if (!half_steps_pending_) {
    store_half_steps();
  }
}

void FixNveDisc::end_step() {
  const double dt = update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    double *v = atom->v[i], *omega = atom->omega[i];
    const double kick = dt / 2 / atom->rmass[i];
    const double spin_kick = 2 * kick / (atom->radius[i] * atom->radius[i]);
    const Four half = half_steps_pending_ ? half_steps_[i].values : Four{v[0], v[1], omega[2], 0};
    v[0] = half[0] + kick * atom->f[i][0];
    v[1] = half[1] + kick * atom->f[i][1];
    omega[2] = half[2] + spin_kick * atom->torque[i][2];
  }
  half_steps_pending_ = false;
  note_end_of_step();
}

/// A signal, a time limit or `fix halt` may have ended the run unexpectedly, in the open state.
void FixNveDisc::post_run() {
  if (packed_ && packed_->open) {
    law_->close();
    law_->copy_histories_to_atoms();
    end_step();
  }
  keep_last_forces();
}

}  // namespace mikromakro::styles
