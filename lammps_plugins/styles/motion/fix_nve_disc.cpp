// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/fix_nve_disc.h"

#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
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
    error->all(FLERR,
               "fix nve/disc: discs require a two-dimensional simulation; put 'dimension 2' before the box");
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
  shared_ = law_ ? &law_->shared_step(*this) : nullptr;
  predicts_ = law_ && predicted_ && law_->velocities_predicted();
  if (shared_) shared_->packed.may_be_open = predicts_ && fused_ && steps_may_be_open(*lmp, *this);
}

/// The engine sorts and exchanges atoms before the first step.
void FixNveDisc::setup_pre_exchange() {
  members_known_ = false;
}

void FixNveDisc::initial_integrate(int /*vflag*/) {
  resume_last_run();
  if (shared_ && shared_->packed.open) {
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

/// Discs are about to change indices and ranks.
void FixNveDisc::pre_exchange() {
  members_known_ = false;
}

void FixNveDisc::final_integrate() {
  prediction_ = Prediction::none;
  if (!shared_ || !shared_->packed.open) {
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

/// A signal, a time limit or `fix halt` may have ended the run unexpectedly, with an open step.
void FixNveDisc::post_run() {
  if (shared_ && shared_->packed.open) {
    law_->close();
    law_->copy_histories_to_atoms();
    end_step();
  }
  if (law_) law_->run_ended();
  keep_last_forces();
}

}  // namespace mikromakro::styles
