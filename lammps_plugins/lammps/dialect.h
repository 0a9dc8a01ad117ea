// SPDX-License-Identifier: GPL-2.0-or-later
// Adapts the engine API used by the styles to LAMMPS; liggghts/dialect.h defines the same names.
#pragma once

#include <cstddef>

#include "comm.h"
#include "command.h"
#include "compute.h"
#include "fix.h"
#include "pointers.h"
#include "update.h"

namespace mikromakro::styles {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using ComputeCreator = LAMMPS_NS::Compute* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using CommandCreator = LAMMPS_NS::Command* (*)(LAMMPS_NS::LAMMPS*);

class FixOfEngine : public LAMMPS_NS::Fix {
 protected:
  using Fix::Fix;
  /// Declares per-atom values, for new atoms too; at most `most_exchanged` values migrate with an atom.
  void has_values_of_atoms(int most_exchanged) {
    create_attribute = 1;
    maxexchange = most_exchanged;
  }

  /// Declares `count` values per ghost, which send_values_to_ghosts() copies from the disc that it is an
  /// image of.
  void has_values_of_ghosts(int count) { comm_forward = count; }
  void send_values_to_ghosts() { forward(*comm); }
  virtual void pack_for_ghost(int /*i*/, double* /*buffer*/) const {}
  virtual void unpack_for_ghost(int /*i*/, const double* /*buffer*/) {}

 private:
  template <class Comm>
  void forward(Comm& comm) {
    if constexpr (requires { comm.forward_comm_fix(this); }) {
      comm.forward_comm_fix(this);
    } else {
      comm.forward_comm(this);
    }
  }
  int pack_forward_comm(int n, int* list, double* buffer, int /*pbc_flag*/, int* /*pbc*/) final {
    for (int k = 0; k < n; ++k)
      pack_for_ghost(list[k], buffer + static_cast<std::ptrdiff_t>(comm_forward) * k);
    return comm_forward * n;
  }
  void unpack_forward_comm(int n, int first, double* buffer) final {
    for (int k = 0; k < n; ++k)
      unpack_for_ghost(first + k, buffer + static_cast<std::ptrdiff_t>(comm_forward) * k);
  }
};

/// A fix that tracks step numbers, and that checks itself as soon as it is defined and its restart state, if
/// any, has been read. The engine does not notify fixes when a script renumbers the steps, so the fix
/// compares the present number with that at the end of its last run.
class FixWithClock : public FixOfEngine {
 public:
  /// The first call after the restart state has been read; post_constructor() comes before.
  int setmask() final {
    once_defined();
    return calls_wanted();
  }
  void post_run() final {
    last_step_ = update->ntimestep;
    run_ended();
  }

 protected:
  FixWithClock(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) : FixOfEngine(engine, narg, arg) {
    last_step_ = update->ntimestep;
  }
  virtual int calls_wanted() const = 0;
  virtual void once_defined() {}
  virtual void run_ended() {}
  virtual void renumber_steps(LAMMPS_NS::bigint shift) = 0;
  /// Call between two runs, before the fix uses a step number.
  void notice_new_count() {
    const LAMMPS_NS::bigint shift = update->ntimestep - last_step_;
    last_step_ = update->ntimestep;
    if (shift != 0) renumber_steps(shift);
  }

 private:
  LAMMPS_NS::bigint last_step_ = 0;
};

/// Drops the index of the style's first argument, which is constant here.
class ComputeOfEngine : public LAMMPS_NS::Compute {
 protected:
  ComputeOfEngine(LAMMPS_NS::LAMMPS* engine, int /*first*/, int narg, char** arg)
      : Compute(engine, narg, arg) {}
};

using CommandOfEngine = LAMMPS_NS::Command;

template <class T>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  return new T(engine, narg, arg);
}

template <class T>
LAMMPS_NS::Compute* make_compute(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  int first = 3;
  return new T(engine, first, narg, arg);
}

template <class T>
LAMMPS_NS::Command* run_command(LAMMPS_NS::LAMMPS* engine) {
  return new T(engine);
}

}  // namespace mikromakro::styles
