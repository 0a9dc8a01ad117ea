// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/engine_access.h"

#include <mpi.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iterator>
#include <numeric>
#include <typeinfo>

#include "atom.h"
#include "comm_brick.h"
#include "engine/private_member.h"
#include "fix_disc_history.h"
#include "fix_nve_sphere.h"
#include "force.h"
#include "integrate.h"
#include "lammps.h"
#include "neighbor.h"
#include "output.h"
#include "pair_disc.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

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
struct MustCheck {
  friend auto member(MustCheck);
};
struct TriggerSquare {
  friend auto member(TriggerSquare);
};

template struct PrivateMember<TriggerSquare, &Neighbor::triggersq>;
template struct PrivateMember<MustCheck, &Neighbor::must_check>;
template struct PrivateMember<ExternalForceClear, &Integrate::external_force_clear>;
template struct PrivateMember<SwapCount, &CommBrick::nswap>;
template struct PrivateMember<SendCounts, &CommBrick::sendnum>;
template struct PrivateMember<SendLists, &CommBrick::sendlist>;

const char* const disc_pair_style = "pair_style disc/linear ...";
const char* const law_styles[] = {"Pair styles:", "tangential"};
const char* const engine_family = "LAMMPS";
namespace {

// The keyword `disc` of fix nve/sphere sets a protected member.
struct SphereIntegrator : FixNVESphere {
  static double inertia_of(const FixNVESphere& fix) { return fix.*(&SphereIntegrator::inertia); }
};

}  // namespace

bool turns_spheres(const Fix& fix) {
  constexpr double of_disc = 0.5;
  const auto* integrator = dynamic_cast<const FixNVESphere*>(&fix);
  return integrator != nullptr && SphereIntegrator::inertia_of(*integrator) < of_disc;
}

const char* const disc_atom_style = "sphere";
const char* const set_density = "set ... density/disc RHO";

std::string engine_name(const LAMMPS& engine) {
  return std::string("LAMMPS ") + engine.version;
}

DiscLaw* active_disc_law(LAMMPS& engine) {
  auto* pair = dynamic_cast<PairDisc*>(engine.force->pair);
  return pair ? &pair->law() : nullptr;
}

std::map<std::string, FixCreator>& fix_styles(Modify& modify) {
  return *modify.fix_map;
}
std::map<std::string, ComputeCreator>& compute_styles(Modify& modify) {
  return *modify.compute_map;
}
std::map<std::string, CommandCreator>& command_styles(Input& input) {
  return *input.command_map;
}

int& forces_are_not_cleared(Integrate& integrate) {
  return integrate.*member(ExternalForceClear{});
}

std::vector<int> atoms_with_ghosts(const Comm& comm, int nlocal) {
  std::vector<int> atoms;
  const auto* bricks = dynamic_cast<const CommBrick*>(&comm);
  if (!bricks) {
    // `comm_style tiled` is not analysed: assume that all atoms have ghosts.
    atoms.resize(nlocal);
    std::iota(atoms.begin(), atoms.end(), 0);
    return atoms;
  }
  for (int swap = 0; swap < bricks->*member(SwapCount{}); ++swap) {
    const int* sent = (bricks->*member(SendLists{}))[swap];
    std::copy_if(sent, sent + (bricks->*member(SendCounts{}))[swap], std::back_inserter(atoms),
                 [nlocal](int i) { return i < nlocal; });
  }
  std::sort(atoms.begin(), atoms.end());
  atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
  return atoms;
}

bool writes_restart_at(const LAMMPS& engine, bigint step) {
  return engine.output->restart_flag && engine.output->next_restart == step;
}

bigint next_restart_step(const LAMMPS& engine) {
  return engine.output->restart_flag ? engine.output->next_restart : -1;
}

int& asks_for_lists(Neighbor& neighbor) {
  return neighbor.*member(MustCheck{});
}

void set_trigger(Neighbor& neighbor, double distance) {
  neighbor.*member(TriggerSquare{}) = distance < 0 ? -1 : distance * distance;
}

/// Queried as the stock granular styles query `fix pour` and `fix deposit`.
double radius_to_come(Fix& fix, int type) {
  const auto* radius = static_cast<const double*>(fix.extract("radius", type));
  return radius ? *radius : 0;
}

double time_now(const LAMMPS& engine) {
  const Update& update = *engine.update;
  return update.atime + static_cast<double>(update.ntimestep - update.atimestep) * update.dt;
}

namespace {

/// True if the error occurred on one rank alone, while the others keep waiting.
template <class Exception>
bool is_of_one_rank(const Exception& exception) {
  // The exception classes differ between versions.
  return std::string(typeid(exception).name()).find("AbortException") != std::string::npos;
}

}  // namespace

/// Newer LAMMPS throws where older versions end the program; the message has already been printed.
int exit_code_of(const std::function<void()>& run) {
  try {
    run();
    return 0;
  } catch (const std::exception& exception) {
    if (is_of_one_rank(exception)) MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return 1;
}

/// The engine's own program does not handle signals.
void handle_signals() {}

bool is_asked_to_stop() {
  return false;
}

bool leaves_discs_alone(const Fix& fix, int mask) {
  using namespace FixConst;
  constexpr int harmless = END_OF_STEP | POST_RUN | MIN_PRE_EXCHANGE | MIN_PRE_NEIGHBOR | MIN_POST_NEIGHBOR |
                           MIN_PRE_FORCE | MIN_PRE_REVERSE | MIN_POST_FORCE | MIN_ENERGY;
  const bool history = dynamic_cast<const FixDiscHistory*>(&fix) != nullptr;
  return fix.box_change == 0 && (mask & ~(harmless | (history ? PRE_EXCHANGE | POST_NEIGHBOR : 0))) == 0;
}

/// The atom style stores no density.
void store_density(Atom& /*atom*/, int /*i*/, double /*areal_density*/) {}

bool stores_discs(const Atom& atom) {
  return atom.radius_flag && atom.rmass_flag;
}

void announce_set_arrays(Fix& /*fix*/) {}

}  // namespace mikromakro::styles
