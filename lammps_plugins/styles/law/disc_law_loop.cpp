// SPDX-License-Identifier: GPL-2.0-or-later
// Pair loop of the disc law: one instance per combination of effects, each with and without recording of
// contacts.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "atom.h"
#include "engine/processor_clones.h"
#include "error.h"
#include "law/disc_law.h"
#include "law/fix_on_rows.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "physics/contact/contact_batch.h"
#include "physics/contact/near_pairs.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::ContactBatch;
using physics::DiscLoad;
using physics::DiscPair;
using physics::DiscRow;
using physics::Effects;
using physics::Tangential;

namespace {

using Vector3 = double[3];

/// Input and output of a batch of pairs.
struct BatchOfPairs {
  const DiscRow* discs;
  DiscLoad* loads;
  const DiscPair* pairs;
  int count;
  int ahead;  // number of following pairs to prefetch
  bool predicted;
  double dt;
};

template <Effects effects>
FOR_EACH_PROCESSOR physics::BatchState batch_geometry(ContactBatch& c, const BatchOfPairs& b) {
  physics::load_discs<effects>(c, b.discs, b.pairs, b.count, b.loads, b.ahead);
  const auto state = physics::contact_geometry<effects>(c, b.count);
  if constexpr (effects.spring()) physics::contact_slip(c, b.count, {b.dt, b.predicted});
  return state;
}

template <Effects effects>
FOR_EACH_PROCESSOR void batch_forces(ContactBatch& c, const BatchOfPairs& b) {
  physics::contact_forces<effects>(c, b.count);
  physics::add_loads<effects>(c, b.pairs, b.count, b.loads);
}

}  // namespace

void DiscLaw::stop_at_coincident_centres(const ContactBatch& c, const DiscPair* pairs) const {
  int lane = 0;
  while (c.is_defined(lane)) ++lane;
  const auto& pair = pairs[lane];
  stop_alone("discs " + std::to_string(atom->tag[pair.i]) + " and " + std::to_string(atom->tag[pair.j]) +
             " have the same centre in step " + std::to_string(evaluated_step_) +
             ": their contact has no normal");
}

/// Packs the discs, owned or ghost, from index `first` on; reading the engine's arrays in the pair loop would
/// cost a cache line per array and neighbour. The returned change is meaningful only if indices are
/// unchanged.
template <bool spins>
DiscLaw::Change DiscLaw::gather(int first) {
  const int count = atom->nlocal + atom->nghost;
  auto& discs = packed_.discs;
  discs.resize(count);
  packed_.loads.resize(count);
  const auto* x = reinterpret_cast<const Vector3*>(atom->x[0]);
  const auto* v = reinterpret_cast<const Vector3*>(atom->v[0]);
  const auto* omega = reinterpret_cast<const Vector3*>(atom->omega[0]);
  double furthest = 0, growth = 0;
  for (int i = first; i < count; ++i) {
    const double d_x = x[i][0] - discs[i].x(), d_y = x[i][1] - discs[i].y();
    furthest = std::max(furthest, d_x * d_x + d_y * d_y);
    growth = std::max(growth, atom->radius[i] - discs[i].radius());
    discs[i] = DiscRow::of(x[i][0], x[i][1], atom->radius[i]);
    discs[i].set_motion(v[i][0], v[i][1], spins ? omega[i][2] : 0.0);
  }
  for (const DiscIntegrator* integrator : integrators_) integrator->predict(discs, first);
  const double moved = std::max(std::sqrt(furthest), first > 0 ? packed_.furthest : 0.0);
  packed_.furthest = 0;
  return {moved, growth};
}

/// Copies the engine's newly built neighbour list into one flat list of pairs.
template <Effects effects>
void DiscLaw::flatten(const NeighList& list) {
  pairs_known_ = true;
  pairs_.clear();
  histories_.clear();
  in_contact_.clear();
  first_pair_.resize(atom->nlocal);
  History springs{};
  if constexpr (effects.spring()) springs = history();
  flags_ = springs.touching;
  ordered_ = true;
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    first_pair_[i] = static_cast<int>(pairs_.size());
    ordered_ = ordered_ && i == ii;
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK});
      ordered_ = ordered_ && pairs_.back().j > i;
      if constexpr (effects.spring()) {
        histories_.push_back(springs.values[i] + static_cast<std::ptrdiff_t>(springs.stride) * jj);
        in_contact_.push_back(springs.touching[i][jj] != 0);
      }
    }
  }
}

namespace {

FOR_EACH_PROCESSOR void find_near(physics::NearPairs& near, const std::vector<DiscPair>& all,
                                  const DiscRow* discs, const std::vector<char>& touched, double gap,
                                  std::size_t ahead) {
  near.find(all, discs, touched, gap, ahead);
}

}  // namespace

/// Rebuilds the inner list: prunes all pairs to those that may touch before the discs have moved by a small
/// part of the skin.
template <Effects effects>
void DiscLaw::find_near_pairs() {
  if (steps_of_near_ > 0) fastest_path_ = moved_ / steps_of_near_;
  near_gap_ = physics::near_gap(fastest_path_, neighbor->skin);
  moved_ = 0;
  steps_of_near_ = 0;
  find_near(near_, pairs_, packed_.discs.data(), in_contact_, near_gap_,
            packed_.exceed_cache() ? ContactBatch::lanes : 0);
  if constexpr (effects.spring()) {
    for (int k = 0; k < near_.size(); ++k) {
      const int number = near_.number(k);
      const double* history = histories_[number];
      near_.set_spring(k, in_contact_[number] != 0, history[history_xi], history[history_slip_rate]);
    }
  }
}

/// In the batch of pairs from `first` on, gives new contacts an unstretched spring and deletes the springs of
/// contacts that ended.
void DiscLaw::begin_and_end_contacts(ContactBatch& c, int first, int count, double dt) {
  for (int k = 0; k < count; ++k) {
    if (c.touches(k) == (c.springs->touched[k] != 0)) continue;
    const int number = near_.number(first + k), i = pairs_[number].i;
    in_contact_[number] = c.touches(k);
    flags_[i][number - first_pair_[i]] = c.touches(k);
    physics::begin_or_end_contact(c, k, {dt, predicted_});
    // A set-up works on a copy of the springs, but contact onset is recorded there too.
    const double slip_rate = c.springs->slip_rate[k];
    near_.set_spring(first + k, c.touches(k), 0, slip_rate);
    histories_[number][history_xi] = 0;
    histories_[number][history_slip_rate] = slip_rate;
  }
}

/// Brings packed disc data and inner list up to date with the present positions.
template <Effects effects>
void DiscLaw::prepare(const Evaluation& evaluation) {
  const bool rows_are_there = packed_.step == update->ntimestep && neighbor->ago != 0;
  const Change change = gather<effects.tangential != Tangential::none>(rows_are_there ? atom->nlocal : 0);
  const bool new_pairs = neighbor->ago == 0 || !pairs_known_;
  if (new_pairs) {
    flatten<effects>(evaluation.list);
    remember_places();
  } else {
    moved_ += change.moved + change.growth;
    path_ += change.moved;
    ++steps_of_near_;
    follow_growth(change.growth);
  }
  if (new_pairs || packed_.look_is_due || 2 * moved_ > near_gap_) {
    packed_.look_is_due = false;
    put_springs_into_engine();
    find_near_pairs<effects>();
  }
}

template <Effects effects, bool observed>
void DiscLaw::act(const Evaluation& evaluation, const MoveDiscs& move_discs) {
  // No time passes in a set-up or a minimisation.
  const bool move_spring = evaluation.is_step && evaluation.moves_springs && update->whichflag == 1;
  const double dt = move_spring ? update->dt : 0.0;
  const bool exceed_cache = packed_.exceed_cache();
  ContactBatch& c = *batch_;
  physics::SpringLanes unmoved;
  for (int k = 0; k < ContactBatch::lanes; ++k) c.set_material(k, parameters_.front());

  for (int first = 0; first < near_.size(); first += ContactBatch::lanes) {
    const int count = std::min(ContactBatch::lanes, near_.size() - first);
    const int ahead = exceed_cache ? std::min(count, near_.size() - first - count) : 0;
    const BatchOfPairs batch{
        packed_.discs.data(), packed_.loads.data(), near_.from(first), count, ahead, predicted_, dt};
    if (!one_material_) set_materials(c, batch.pairs, count);
    if (effects.spring()) {
      c.springs = &near_.springs(first);
      if (!move_spring) c.springs = &(unmoved = *c.springs);
      near_.fetch_springs(first + count, ahead);
    }
    const auto state = batch_geometry<effects>(c, batch);
    if (state.any_undefined) stop_at_coincident_centres(c, batch.pairs);
    if (state.any_changed) begin_and_end_contacts(c, first, count, dt);
    batch_forces<effects>(c, batch);
    if constexpr (observed) {
      for (int k = 0; k < count; ++k) {
        if (c.touches(k)) observe(evaluation, c, k, first);
      }
    }
    // The following pairs involve no disc before the first disc of the next pair.
    if (move_discs && ordered_ && first + count < near_.size()) move_discs(batch.pairs[count].i);
  }
  springs_wait_ = springs_wait_ || (effects.spring() && move_spring);
  if (!packed_.may_stay_open) put_springs_into_engine();
  if (!evaluation.is_step) {
    std::fill(packed_.loads.begin(), packed_.loads.end(), DiscLoad{});
  } else if (packed_.open) {
    // Loads of ghosts are computed on their own ranks.
    std::fill(packed_.loads.begin() + atom->nlocal, packed_.loads.end(), DiscLoad{});
  } else {
    close();
  }
}

void DiscLaw::set_materials(ContactBatch& c, const DiscPair* pairs, int count) const {
  const std::size_t types = atom->ntypes;
  for (int k = 0; k < count; ++k) {
    const auto& pair = pairs[k];
    c.set_material(k, parameters_[(atom->type[pair.i] - 1) * types + atom->type[pair.j] - 1]);
  }
}

/// Passes a contact to our own record and to the engine, if they want it.
void DiscLaw::observe(const Evaluation& evaluation, const ContactBatch& c, int k, int first) {
  const auto [i, j] = near_.from(first)[k];
  if (recording_) {
    const double xi = effects_.spring() ? c.springs->xi[k] : 0.0;
    applied_.push_back(
        {i, j, c.n_x[k], c.n_y[k], c.overlap[k], {c.f_n[k], c.f_t[k], xi}, c.v_n[k], c.v_t[k]});
  }
  if (evaluation.is_observed) {
    tell_engine({i, j, c.d_x[k], c.d_y[k], c.overlap[k], c.f_x[k], c.f_y[k],
                 packed_.discs[i].radius() * c.f_t[k] - c.short_torque[k],
                 effects_.spring() ? histories_[near_.number(first + k)] : nullptr});
  }
}

template <Effects effects>
void DiscLaw::use_loops_of() {
  if (effects_ != effects) return;
  preparation_ = &DiscLaw::prepare<effects>;
  plain_loop_ = &DiscLaw::act<effects, false>;
  observed_loop_ = &DiscLaw::act<effects, true>;
}

template <int... numbers>
void DiscLaw::choose_among(std::integer_sequence<int, numbers...> /*combinations*/) {
  (use_loops_of<physics::effects_of_combination(numbers)>(), ...);
}

void DiscLaw::choose_loops() {
  choose_among(std::make_integer_sequence<int, physics::effect_combinations>{});
}

}  // namespace mikromakro::styles
