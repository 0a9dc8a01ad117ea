// SPDX-License-Identifier: GPL-2.0-or-later
// Adapts the engine API used by the styles to LIGGGHTS; lammps/dialect.h defines the same names.
#pragma once

#include <cstddef>

#include "comm.h"
#include "compute.h"
#include "fix.h"
#include "pointers.h"

namespace mikromakro::styles {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using ComputeCreator = LAMMPS_NS::Compute* (*)(LAMMPS_NS::LAMMPS*, int, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

class FixOfEngine : public LAMMPS_NS::Fix {
 protected:
  using Fix::Fix;
  /// Declares per-atom values, for new atoms too; at most `most_exchanged` values migrate with an atom.
  void has_values_of_atoms(int /*most_exchanged*/) {
    create_attribute = 1;
    // Otherwise the engine would clear the values of all atoms in the first set-up of a new fix.
    just_created = 0;
  }

  /// Declares `count` values per ghost, which send_values_to_ghosts() copies from the disc that it is an
  /// image of.
  void has_values_of_ghosts(int count) { comm_forward = count; }
  void send_values_to_ghosts() { comm->forward_comm_fix(this); }
  virtual void pack_for_ghost(int /*i*/, double* /*buffer*/) const {}
  virtual void unpack_for_ghost(int /*i*/, const double* /*buffer*/) {}

 private:
  int pack_comm(int n, int* list, double* buffer, int /*pbc_flag*/, int* /*pbc*/) final {
    for (int k = 0; k < n; ++k)
      pack_for_ghost(list[k], buffer + static_cast<std::ptrdiff_t>(comm_forward) * k);
    return comm_forward;
  }
  void unpack_comm(int n, int first, double* buffer) final {
    for (int k = 0; k < n; ++k)
      unpack_for_ghost(first + k, buffer + static_cast<std::ptrdiff_t>(comm_forward) * k);
  }
};

/// A fix that tracks step numbers, and that checks itself as soon as it is defined and its restart state, if
/// any, has been read.
class FixWithClock : public FixOfEngine {
 public:
  int setmask() final { return calls_wanted(); }
  void post_create() final { once_defined(); }
  void post_run() final { run_ended(); }
  void reset_timestep(LAMMPS_NS::bigint newstep, LAMMPS_NS::bigint oldstep) final {
    renumber_steps(newstep - oldstep);
  }

 protected:
  using FixOfEngine::FixOfEngine;
  virtual int calls_wanted() const = 0;
  virtual void once_defined() {}
  virtual void run_ended() {}
  virtual void renumber_steps(LAMMPS_NS::bigint shift) = 0;
  /// Nothing to do: the engine notifies the fix directly.
  void notice_new_count() {}
};

using ComputeOfEngine = LAMMPS_NS::Compute;

class CommandOfEngine : protected LAMMPS_NS::Pointers {
 public:
  virtual void command(int narg, char** arg) = 0;

 protected:
  using Pointers::Pointers;
};

template <class T>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  return new T(engine, narg, arg);
}

template <class T>
LAMMPS_NS::Compute* make_compute(LAMMPS_NS::LAMMPS* engine, int iarg, int narg, char** arg) {
  return new T(engine, iarg, narg, arg);
}

template <class T>
void run_command(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  T(engine).command(narg, arg);
}

}  // namespace mikromakro::styles
