// SPDX-License-Identifier: GPL-2.0-or-later
// Data not yet written back to the engine's arrays, displacements of discs, and the write-back.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <mpi.h>

#include "atom.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/processor_clones.h"
#include "law/disc_law.h"
#include "neighbor.h"
#include "update.h"

namespace mikromakro::styles {

using physics::DiscLoad;
using physics::DiscRow;
using physics::Tangential;

namespace {

/// Largest squared displacement of the leading (owned) discs from their positions in `from`.
FOR_EACH_PROCESSOR double furthest_squared(const DiscRow* discs,
                                           const std::vector<physics::PlaneVector>& from) {
  double furthest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double d_x = discs[i].x() - from[i].x, d_y = discs[i].y() - from[i].y;
    furthest = std::max(furthest, d_x * d_x + d_y * d_y);
  }
  return furthest;
}

}  // namespace

/// The engine's Error::one is silent on all ranks but the first, and its message is lost if the output is a
/// pipe.
void DiscLaw::stop_alone(const std::string& what) const {
  const std::string text = "ERROR: " + style() + ": " + what + "\n";
  if (logfile) std::fputs(text.c_str(), logfile);
  std::fflush(nullptr);
  std::fputs(text.c_str(), stderr);
  MPI_Abort(world, 1);
  std::abort();
}

/// The engine lists pairs with a gap below the skin, but searches only within the reach of the largest discs
/// at the start of the run.
void DiscLaw::remember_places() {
  path_ = 0;
  built_at_.clear();
  double beyond = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    built_at_.push_back({packed_.discs[i].x(), packed_.discs[i].y()});
    const double radius = atom->radius[i];
    if (!(radius > 0) || !(atom->rmass[i] > 0)) {
      stop_alone("disc " + std::to_string(atom->tag[i]) + ": expected a radius and a mass > 0, got " +
                 text_of(radius) + " m and " + text_of(atom->rmass[i]) + " kg");
    }
    beyond = std::max(beyond, radius - largest_radii_[atom->type[i]]);
  }
  if (beyond > 0.4 * neighbor->skin) {
    stop_alone("discs have grown by " + text_of(beyond) +
               " m beyond the largest of the start of the run, for which the engine looks for neighbours; "
               "expected at most 0.4 of the skin, " +
               text_of(0.4 * neighbor->skin) + " m: a larger 'neighbor' distance, or 'run N every M'");
  }
  // The growth in a step with a list build is unknown, since indices change; assume that of the last step.
  beyond_lists_ = beyond + growth_;
  lessen_trigger(lists_are_old_ ? neighbor->skin : beyond_lists_ + growth_);
  lists_are_old_ = false;
}

/// Growing discs approach each other as if they moved. The engine rebuilds its lists as soon as motion and
/// growth together may have used up half the skin, or may do so in the next step.
void DiscLaw::follow_growth(double growth) {
  if (growth == 0 && growth_ == 0) return;
  if (growth > neighbor->skin / 2) {
    stop_alone("a radius has grown by " + text_of(growth) +
               " m in a step; expected at most half of the neighbour list's skin, " +
               text_of(neighbor->skin / 2) + " m");
  }
  growth_ = growth;
  beyond_lists_ += growth;
  lessen_trigger(beyond_lists_ + growth);
}

void DiscLaw::lessen_trigger(double by) {
  set_trigger(*neighbor, neighbor->skin / 2 - by);
}

namespace {

/// Whole steps of length `step` [m] in a distance, capped at 1000.
int steps_along(double way, double step) {
  constexpr int plenty = 1000;
  return way < plenty * step ? std::max(0, static_cast<int>(way / step)) : plenty;
}

}  // namespace

int DiscLaw::steps_neighbours_suffice() {
  const double trigger = std::max(0.0, neighbor->skin / 2 * (1 - 1e-6) - beyond_lists_);  // rounding
  const auto steps_from = [&](double gone) {
    return gone < trigger ? 1 + steps_along(trigger - gone, 6 * packed_.furthest) : 0;
  };
  const int steps = steps_from(path_ + packed_.furthest);
  if (steps > 0 || path_ >= 2 * trigger) return steps;  // already known to be close to the trigger
  const double now = std::sqrt(furthest_squared(packed_.discs.data(), built_at_));
  path_ = now < 0.9 * trigger ? now - packed_.furthest : 2 * trigger;
  return steps_from(path_ + packed_.furthest);
}

int DiscLaw::steps_near_pairs_suffice() const {
  return steps_along(near_gap_ / 2 - moved_, packed_.furthest);
}

void DiscLaw::put_disc_into_engine(int i) {
  const auto& disc = packed_.discs[i];
  atom->x[i][0] = disc.x();
  atom->x[i][1] = disc.y();
  atom->v[i][0] = disc.motion[0];
  atom->v[i][1] = disc.motion[1];
  // Without friction, spins do not change and were not loaded.
  if (effects_.tangential != Tangential::none) atom->omega[i][2] = disc.motion[2];
}

void DiscLaw::put_discs_into_engine() {
  for (int i = 0; i < atom->nlocal; ++i) put_disc_into_engine(i);
}

void DiscLaw::put_springs_into_engine() {
  if (!springs_wait_) return;
  for (int k = 0; k < near_.size(); ++k) {
    double* history = histories_[near_.number(k)];
    history[history_xi] = near_.xi(k);
    history[history_slip_rate] = near_.slip_rate(k);
  }
  springs_wait_ = false;
}

/// Adds the loads of the owned discs to the engine's forces and torques, and clears them for the next step.
void DiscLaw::close() {
  complete_step();
  if (packed_.step == update->ntimestep) put_discs_into_engine();
  put_springs_into_engine();
  using Vector3 = double[3];
  auto* f = reinterpret_cast<Vector3*>(atom->f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom->torque[0]);
  const int nlocal = atom->nlocal;
  for (int i = 0; i < nlocal && forces_are_stale_; ++i) f[i][0] = f[i][1] = torque[i][2] = 0;
  forces_are_stale_ = false;
  for (int i = 0; i < nlocal; ++i) {
    f[i][0] += packed_.loads[i].f_x();
    f[i][1] += packed_.loads[i].f_y();
  }
  if (effects_.tangential != Tangential::none) {
    for (int i = 0; i < nlocal; ++i) torque[i][2] += packed_.loads[i].torque(packed_.discs[i].radius());
  }
  std::fill(packed_.loads.begin(), packed_.loads.end(), DiscLoad{});
  packed_.open = false;
  packed_.step = -1;
}

}  // namespace mikromakro::styles
