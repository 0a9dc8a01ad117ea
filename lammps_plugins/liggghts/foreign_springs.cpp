// SPDX-License-Identifier: GPL-2.0-or-later
// For a restart file of a run under another law, whose springs are not ours.
#include <cstring>

#include "engine/arguments.h"
#include "engine/first_rank.h"
#include "engine/private_member.h"
#include "modify.h"
#include "pair_gran_disc.h"

namespace mikromakro::styles {

using LAMMPS_NS::Modify;

struct GlobalIds {
  friend auto member(GlobalIds);
};
struct GlobalStates {
  friend auto member(GlobalStates);
};
struct AtomIds {
  friend auto member(AtomIds);
};

template struct PrivateMember<GlobalIds, &Modify::id_restart_global>;
template struct PrivateMember<GlobalStates, &Modify::state_restart_global>;
template struct PrivateMember<AtomIds, &Modify::id_restart_peratom>;

namespace {

const char* const springs_id = "contacthistory";

/// Renames the data so that no fix finds them.
void leave_aside(char* id) {
  *id = '-';
}

}  // namespace

/// Prevents the engine from stopping the run with its own message. The number of values per spring is stored
/// in the file.
void PairGranDisc::discard_foreign_springs() {
  if (!effects().spring()) return;
  Modify& engine = *modify;
  for (int k = 0; k < engine.nfix_restart_global; ++k) {
    char* id = (engine.*member(GlobalIds{}))[k];
    double numbers = 0;
    std::memcpy(&numbers, (engine.*member(GlobalStates{}))[k], sizeof numbers);
    if (std::strcmp(id, springs_id) != 0 || numbers == history_size) continue;
    leave_aside(id);
    for (int m = 0; m < engine.nfix_restart_peratom; ++m) {
      char* of_atoms = (engine.*member(AtomIds{}))[m];
      if (std::strcmp(of_atoms, springs_id) == 0) leave_aside(of_atoms);
    }
    print_line(*DiscLaw::lmp, "WARNING: " + style() + ": the restart file holds springs of another law, " +
                                  text_of(numbers) +
                                  " numbers each: they are discarded, and all springs start at zero");
  }
}

}  // namespace mikromakro::styles
