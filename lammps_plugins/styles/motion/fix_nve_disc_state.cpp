// SPDX-License-Identifier: GPL-2.0-or-later
// fix nve/disc: per-atom data, restart, and continuation from the last run.
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"
#include "motion/fix_nve_disc.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Four;

/// Decides, before forces are evaluated, whether the last run is continued; the forces then use the
/// velocities of the last evaluation. Not possible if the box remaps velocities at its boundaries: the
/// velocities of ghosts then differ from those of their discs.
void FixNveDisc::setup_pre_force(int /*vflag*/) {
  prediction_ = Prediction::none;
  resumes_ = law_ && !domain->deform_vremap && last_forces_.nothing_changed();
  if (!resumes_) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto& [v_x, v_y, spin] = last_forces_.velocities(i);
    predictions_[i].values = Four{v_x, v_y, spin, 0};
  }
  prediction_ = Prediction::velocities;
}

void FixNveDisc::setup(int /*vflag*/) {
  prediction_ = Prediction::none;
  members_known_ = false;
}

/// A run from the restart file of this step will sort its discs in its set-up, so this run sorts as well.
void FixNveDisc::resume_last_run() {
  if (update->ntimestep == next_restart_step(*lmp)) atom->nextsort = update->ntimestep;
  if (!resumes_) return;
  resumes_ = false;
  last_forces_.restore(groupbit, law_->strongest_contact());
}

/// Forces may be re-evaluated before the step is stored.
void FixNveDisc::note_end_of_step() {
  step_complete_ = true;
  const bool may_be_kept = update->ntimestep == update->laststep || is_asked_to_stop() ||
                           writes_restart_at(*lmp, update->ntimestep);
  if (!may_be_kept || !law_ || shared_->packed.discs.size() < static_cast<std::size_t>(atom->nlocal)) return;
  last_forces_.store_velocities(shared_->packed.discs.data(), law_->rows_have_spins());
  velocities_step_ = update->ntimestep;
}

void FixNveDisc::keep_last_forces() {
  if (!step_complete_ || !law_ || shared_->packed.discs.size() < static_cast<std::size_t>(atom->nlocal))
    return;
  if (velocities_step_ != update->ntimestep)
    last_forces_.store_velocities(shared_->packed.discs.data(), law_->rows_have_spins());
  last_forces_.store_discs();
}

/// Within a run, the engine writes the springs as of the last neighbour list build, and no forces. The
/// command write_restart first initialises the engine, which copies the springs and may migrate atoms between
/// ranks, so that atom->f no longer belongs to them.
void FixNveDisc::write_restart(FILE* file) {
  if (step_complete_) {
    keep_last_forces();
    if (law_) law_->copy_histories_to_atoms();
  }
  if (comm->me != 0) return;
  constexpr int format = 2, size = sizeof format;
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(&format, sizeof format, 1, file);
}

void FixNveDisc::grow_arrays(int nmax) {
  predictions_.resize(nmax);
  half_steps_.resize(nmax);
  spin_kicks_.resize(nmax);
  last_forces_.grow(nmax);
}

void FixNveDisc::set_arrays(int i) {
  predictions_[i].values = Four{0, 0, 0, 0};
  last_forces_.forget(i);
}

void FixNveDisc::copy_arrays(int from, int to, int /*delflag*/) {
  predictions_[to] = predictions_[from];
  half_steps_[to] = half_steps_[from];
  spin_kicks_[to] = spin_kicks_[from];
  last_forces_.copy(from, to);
}

void FixNveDisc::pack_prediction(int i, double* buffer) const {
  for (int k = 0; k < size_of_prediction; ++k) buffer[k] = predictions_[i].values[k];
}

void FixNveDisc::unpack_prediction(int i, const double* buffer) {
  predictions_[i].values = Four{buffer[0], buffer[1], buffer[2], 0};
}

void FixNveDisc::pack_for_ghost(int i, double* buffer) const {
  pack_prediction(i, buffer);
  buffer[size_of_prediction] = atom->radius[i];
}

void FixNveDisc::unpack_for_ghost(int i, const double* buffer) {
  unpack_prediction(i, buffer);
  atom->radius[i] = buffer[size_of_prediction];
}

int FixNveDisc::pack_exchange(int i, double* buffer) {
  std::memcpy(buffer, &half_steps_[i], sizeof(OfDisc));
  buffer[size_of_half_step - 1] = spin_kicks_[i];
  double* rest = buffer + size_of_half_step;
  pack_prediction(i, rest);
  return size_of_half_step + size_of_prediction + last_forces_.pack(i, rest + size_of_prediction);
}

int FixNveDisc::unpack_exchange(int i, double* buffer) {
  std::memcpy(&half_steps_[i], buffer, sizeof(OfDisc));
  spin_kicks_[i] = buffer[size_of_half_step - 1];
  const double* rest = buffer + size_of_half_step;
  unpack_prediction(i, rest);
  return size_of_half_step + size_of_prediction + last_forces_.unpack(i, rest + size_of_prediction);
}

int FixNveDisc::pack_restart(int i, double* buffer) {
  buffer[0] = maxsize_restart();
  return 1 + last_forces_.pack(i, buffer + 1);
}

void FixNveDisc::unpack_restart(int nlocal, int nth) {
  const double* extra = atom->extra[nlocal];
  int start = 0;
  for (int k = 0; k < nth; ++k) start += static_cast<int>(extra[start]);
  // Files of older versions store less of the last step: their runs continue with the forces of the set-up.
  if (extra[start] == maxsize_restart())
    last_forces_.unpack(nlocal, extra + start + 1);
  else
    last_forces_.forget(nlocal);
}

int FixNveDisc::size_restart(int /*nlocal*/) {
  return maxsize_restart();
}

int FixNveDisc::maxsize_restart() {
  return 1 + LastForces::values;
}

double FixNveDisc::memory_usage() {
  return static_cast<double>(half_steps_.size() * (2 * sizeof(OfDisc) + sizeof(double))) +
         last_forces_.memory_usage();
}

}  // namespace mikromakro::styles
