// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/skin_budget.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "atom.h"
#include "engine/abort_run.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/processor_clones.h"
#include "modify.h"
#include "neighbor.h"
#include "physics/contact/inner_list.h"

namespace mikromakro::styles {

using physics::DiscRow;

namespace {

/// Factor by which discs may speed up within the steps that steps_lists_stay_valid() promises. Holds for the
/// four steps that the integrator asks for at most: see FixNveDisc::lists_stay_valid().
constexpr double largest_speed_up = 6;
/// Displacements are measured only if they may leave this part of the trigger unspent; beyond it the lists
/// count as old, so that they are not measured again in every step until the engine rebuilds them.
constexpr double nearly_spent = 0.9;
/// Longer promises have no use.
constexpr int most_steps = 1000;
/// Growth of radii beyond largest_radius(), in skins: two such discs still lie within the engine's search
/// distance, with a fifth of the skin left for their motion.
constexpr double most_excess = 0.4;
/// Keeps our sum of displacements below the trigger that the engine computes.
constexpr double rounding_of_trigger = 1e-6, rounding_of_sum = 1e-12;

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

/// Whole steps of length `step` [m] in a distance [m].
int steps_along(double distance, double step) {
  return distance < most_steps * step ? std::max(0, static_cast<int>(distance / step)) : most_steps;
}

}  // namespace

void SkinBudget::begin_run(std::string style) {
  style_ = std::move(style);
  find_largest_radii();
  sum_of_radii_ = sum_of_radii();
  growth_ = 0;
}

void SkinBudget::find_largest_radii() {
  largest_radii_.assign(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; ++i) {
    double& largest = largest_radii_[atom->type[i]];
    largest = std::max(largest, atom->radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, largest_radii_.data(), static_cast<int>(largest_radii_.size()), MPI_DOUBLE,
                MPI_MAX, world);
  for (LAMMPS_NS::Fix* fix : fixes(*modify))
    for (int type = 1; type <= atom->ntypes; ++type)
      largest_radii_[type] = std::max(largest_radii_[type], radius_to_come(*fix, type));
}

double SkinBudget::sum_of_radii() const {
  double sum = std::accumulate(atom->radius, atom->radius + atom->nlocal, 0.0);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

void SkinBudget::check_growth_in_set_up() {
  grew_in_set_up_ = sum_of_radii() > sum_of_radii_ * (1 + rounding_of_sum);
}

/// Growth of an owned disc beyond the largest of its type at the start of the run [m].
double SkinBudget::excess_radius(int i) const {
  const double radius = atom->radius[i];
  if (!(radius > 0) || !(atom->rmass[i] > 0)) {
    abort_run(*lmp, style_,
              "disc " + std::to_string(atom->tag[i]) + ": expected a radius and a mass > 0, got " +
                  text_of(radius) + " m and " + text_of(atom->rmass[i]) + " kg");
  }
  return radius - largest_radii_[atom->type[i]];
}

/// The engine lists pairs with a gap below the skin, but searches only as far as the largest discs at the
/// start of the run require.
void SkinBudget::lists_were_built(const std::vector<DiscRow>& discs) {
  path_ = 0;
  built_at_.clear();
  double excess = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    built_at_.push_back({discs[i].x(), discs[i].y()});
    excess = std::max(excess, excess_radius(i));
  }
  if (excess > most_excess * neighbor->skin) {
    abort_run(*lmp, style_,
              "discs have grown by " + text_of(excess) +
                  " m beyond the largest radius at the start of the run, for which the engine builds its "
                  "neighbour lists; expected at most 0.4 of the skin, " +
                  text_of(most_excess * neighbor->skin) +
                  " m: a larger 'neighbor' distance, or 'run N every M'");
  }
  // The growth in a step with a list build is unknown, since indices change; assume that of the last step.
  excess_ = excess + growth_;
  reduce_trigger(grew_in_set_up_ ? neighbor->skin : excess_ + growth_);
  grew_in_set_up_ = false;
}

void SkinBudget::spend(const DiscChange& change) {
  inner_path_ += change.moved + change.growth;
  path_ += change.moved;
  ++inner_steps_;
  follow_growth(change.growth);
}

/// The engine rebuilds its lists as soon as motion and growth together may have spent half the skin, or may
/// do so in the next step.
void SkinBudget::follow_growth(double growth) {
  if (growth == 0 && growth_ == 0) return;
  if (growth > neighbor->skin / 2) {
    abort_run(*lmp, style_,
              "a radius has grown by " + text_of(growth) +
                  " m in a step; expected at most half of the neighbour list's skin, " +
                  text_of(neighbor->skin / 2) + " m");
  }
  growth_ = growth;
  excess_ += growth;
  reduce_trigger(excess_ + growth);
}

void SkinBudget::reduce_trigger(double by) {
  set_trigger(*neighbor, neighbor->skin / 2 - by);
}

int SkinBudget::steps_lists_stay_valid(const PackedDiscs& packed) {
  const double step = packed.furthest;
  const double trigger = std::max(0.0, neighbor->skin / 2 * (1 - rounding_of_trigger) - excess_);
  const double beyond_trigger = 2 * trigger;  // value of path_ for lists that count as old
  const auto steps_from = [&](double path) {
    return path < trigger ? 1 + steps_along(trigger - path, largest_speed_up * step) : 0;
  };
  const int steps = steps_from(path_ + step);
  if (steps > 0 || path_ >= beyond_trigger) return steps;
  const double now = std::sqrt(furthest_squared(packed.discs.data(), built_at_));
  path_ = now < nearly_spent * trigger ? now - step : beyond_trigger;
  return steps_from(path_ + step);
}

double SkinBudget::begin_inner_list() {
  if (inner_steps_ > 0) fastest_path_ = inner_path_ / inner_steps_;
  inner_gap_ = physics::inner_gap(fastest_path_, neighbor->skin);
  inner_path_ = 0;
  inner_steps_ = 0;
  return inner_gap_;
}

int SkinBudget::steps_inner_list_stays_valid(const PackedDiscs& packed) const {
  return steps_along(inner_gap_ / 2 - inner_path_, packed.furthest);
}

}  // namespace mikromakro::styles
