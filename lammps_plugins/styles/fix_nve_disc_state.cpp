// fix nve/disc: what it stores per atom and in restart files, and how a run goes on where the last one ended.
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "disc_law.h"
#include "engine_access.h"
#include "fix_nve_disc.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

void FixNveDisc::setup(int /*vflag*/) {
  resumes_ = true;
}

/// A run that starts from the file of this step will sort its discs in its set-up.
void FixNveDisc::go_on_from_last_run() {
  if (update->ntimestep == next_restart_step(*lmp)) atom->nextsort = update->ntimestep;
  if (!resumes_) return;
  resumes_ = false;
  last_forces_.restore(groupbit);
}

void FixNveDisc::note_end_of_step() {
  step_complete_ = true;
  if (update->ntimestep == update->laststep) last_forces_.keep(groupbit);
}

/// Within a run, the engine writes the springs as they were when the neighbour list was built, and has no
/// forces in the file. The command write_restart initialises the engine before, which copies the springs, and
/// may move atoms between the ranks, so that atom->f is no longer theirs.
void FixNveDisc::write_restart(FILE* file) {
  if (step_complete_) {
    last_forces_.keep(groupbit);
    if (law_) law_->keep_springs_with_atoms();
  }
  if (comm->me != 0) return;
  constexpr int format = 1, size = sizeof format;
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(&format, sizeof format, 1, file);
}

void FixNveDisc::grow_arrays(int nmax) {
  half_steps_.resize(nmax);
  spin_kicks_.resize(nmax);
  last_forces_.grow(nmax);
}

void FixNveDisc::set_arrays(int i) {
  last_forces_.forget(i);
}

void FixNveDisc::copy_arrays(int from, int to, int /*delflag*/) {
  half_steps_[to] = half_steps_[from];
  spin_kicks_[to] = spin_kicks_[from];
  last_forces_.copy(from, to);
}

int FixNveDisc::pack_exchange(int i, double* buffer) {
  std::memcpy(buffer, &half_steps_[i], sizeof(HalfStep));
  buffer[size_of_half_step - 1] = spin_kicks_[i];
  return size_of_half_step + last_forces_.pack(i, buffer + size_of_half_step);
}

int FixNveDisc::unpack_exchange(int i, double* buffer) {
  std::memcpy(&half_steps_[i], buffer, sizeof(HalfStep));
  spin_kicks_[i] = buffer[size_of_half_step - 1];
  return size_of_half_step + last_forces_.unpack(i, buffer + size_of_half_step);
}

int FixNveDisc::pack_restart(int i, double* buffer) {
  buffer[0] = maxsize_restart();
  return 1 + last_forces_.pack(i, buffer + 1);
}

void FixNveDisc::unpack_restart(int nlocal, int nth) {
  const double* extra = atom->extra[nlocal];
  int start = 0;
  for (int k = 0; k < nth; ++k) start += static_cast<int>(extra[start]);
  last_forces_.unpack(nlocal, extra + start + 1);
}

int FixNveDisc::size_restart(int /*nlocal*/) {
  return maxsize_restart();
}

int FixNveDisc::maxsize_restart() {
  return 1 + LastForces::values;
}

double FixNveDisc::memory_usage() {
  return static_cast<double>(half_steps_.size() * (sizeof(HalfStep) + sizeof(double))) +
         last_forces_.memory_usage();
}

}  // namespace mikromakro::styles
