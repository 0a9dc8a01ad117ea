// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS 3.8 has no plugin command, and its style tables are private or protected.
#include "engine/engine_access.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <iterator>

#include "atom.h"
#include "comm.h"
#include "engine/private_member.h"
#include "integrate.h"
#include "lammps.h"
#include "neighbor.h"
#include "output.h"
#include "signal_handling.h"
#include "universe.h"
#include "update.h"

namespace mikromakro::styles {

struct FixMap {
  friend auto member(FixMap);
};
struct ComputeMap {
  friend auto member(ComputeMap);
};
struct CommandMap {
  friend auto member(CommandMap);
};
struct ExternalForceClear {
  friend auto member(ExternalForceClear);
};
struct SwapCount {
  friend auto member(SwapCount);
};
struct SendCounts {
  friend auto member(SendCounts);
};
struct SendLists {
  friend auto member(SendLists);
};
struct TriggerSquare {
  friend auto member(TriggerSquare);
};
struct MustCheck {
  friend auto member(MustCheck);
};
struct NextRestart {
  friend auto member(NextRestart);
};

template struct PrivateMember<TriggerSquare, &LAMMPS_NS::Neighbor::triggersq>;
template struct PrivateMember<MustCheck, &LAMMPS_NS::Neighbor::must_check>;
template struct PrivateMember<NextRestart, &LAMMPS_NS::Output::next_restart>;
template struct PrivateMember<ExternalForceClear, &LAMMPS_NS::Integrate::external_force_clear>;
template struct PrivateMember<SwapCount, &LAMMPS_NS::Comm::nswap>;
template struct PrivateMember<SendCounts, &LAMMPS_NS::Comm::sendnum>;
template struct PrivateMember<SendLists, &LAMMPS_NS::Comm::sendlist>;
template struct PrivateMember<FixMap, &LAMMPS_NS::Modify::fix_map>;
template struct PrivateMember<ComputeMap, &LAMMPS_NS::Modify::compute_map>;
template struct PrivateMember<CommandMap, &LAMMPS_NS::Input::command_map>;

std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify) {
  return *(modify.*member(FixMap{}));
}
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify) {
  return *(modify.*member(ComputeMap{}));
}
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input) {
  return *(input.*member(CommandMap{}));
}

int& forces_are_not_cleared(LAMMPS_NS::Integrate& integrate) {
  return integrate.*member(ExternalForceClear{});
}

std::vector<int> atoms_with_ghosts(const LAMMPS_NS::Comm& comm, int nlocal) {
  std::vector<int> atoms;
  for (int swap = 0; swap < comm.*member(SwapCount{}); ++swap) {
    const int* sent = (comm.*member(SendLists{}))[swap];
    std::copy_if(sent, sent + (comm.*member(SendCounts{}))[swap], std::back_inserter(atoms),
                 [nlocal](int i) { return i < nlocal; });
  }
  std::sort(atoms.begin(), atoms.end());
  atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
  return atoms;
}

bool writes_restart_at(const LAMMPS_NS::LAMMPS& engine, LAMMPS_NS::bigint step) {
  return engine.output->restart_requested(step);
}

LAMMPS_NS::bigint next_restart_step(const LAMMPS_NS::LAMMPS& engine) {
  return engine.output->*member(NextRestart{});
}

int& asks_for_lists(LAMMPS_NS::Neighbor& neighbor) {
  return neighbor.*member(MustCheck{});
}

void set_trigger(LAMMPS_NS::Neighbor& neighbor, double distance) {
  neighbor.*member(TriggerSquare{}) = distance < 0 ? -1 : distance * distance;
}

double radius_to_come(LAMMPS_NS::Fix& fix, int type) {
  return fix.max_rad(type);
}

double time_now(const LAMMPS_NS::LAMMPS& engine) {
  return engine.update->get_cur_time();
}

/// The engine ends the program itself on errors.
int exit_code_of(const std::function<void()>& run) {
  run();
  return 0;
}

/// As in the engine's own program: SIGINT and SIGTERM end the run after the current step and write pending
/// output; SIGUSR1 requests a restart file. mpirun forwards SIGINT as SIGTERM.
void handle_signals() {
  struct sigaction end_run {};
  end_run.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigaction(SIGINT, &end_run, nullptr);
  sigaction(SIGTERM, &end_run, nullptr);
  struct sigaction write_now {};
  write_now.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &write_now, nullptr);
}

bool is_asked_to_stop() {
  return LAMMPS_NS::SignalHandler::request_quit || LAMMPS_NS::SignalHandler::request_write_restart;
}

bool leaves_discs_alone(const LAMMPS_NS::Fix& fix, int mask) {
  using namespace LAMMPS_NS::FixConst;
  constexpr int harmless = END_OF_STEP | THERMO_ENERGY | POST_RUN | MIN_PRE_EXCHANGE | MIN_PRE_NEIGHBOR |
                           MIN_PRE_FORCE | MIN_POST_FORCE | MIN_ENERGY;
  const bool history = std::strcmp(fix.style, "contacthistory") == 0;
  const bool changes_box = fix.box_change_size || fix.box_change_shape || fix.box_change_domain;
  return !changes_box && (mask & ~(harmless | (history ? PRE_EXCHANGE : 0))) == 0;
}

void store_density(LAMMPS_NS::Atom& atom, int i, double areal_density) {
  atom.density[i] = areal_density;
}

bool stores_discs(const LAMMPS_NS::Atom& atom) {
  return atom.radius_flag && atom.rmass_flag && atom.density_flag;
}

void announce_set_arrays(LAMMPS_NS::Fix& fix) {
  fix.pre_set_arrays();
}

const char* const engine_family = "LIGGGHTS";
// The fix nve/sphere of LIGGGHTS uses the inertia of discs in two dimensions.
bool turns_spheres(const LAMMPS_NS::Fix& /*fix*/) {
  return false;
}

const char* const disc_atom_style = "granular";
const char* const set_density = "set ... density RHO";

std::string engine_name(const LAMMPS_NS::LAMMPS& engine) {
  return engine.universe->version;
}

}  // namespace mikromakro::styles
