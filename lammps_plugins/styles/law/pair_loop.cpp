// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/pair_loop.h"

#include <algorithm>
#include <utility>

#include "engine/processor_clones.h"

namespace mikromakro::styles {

using physics::ContactBatch;
using physics::DiscLoad;
using physics::DiscPair;
using physics::DiscRow;
using physics::Effects;

namespace {

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

void set_materials(ContactBatch& c, const PairPass& pass, const DiscPair* pairs, int count) {
  for (int k = 0; k < count; ++k)
    c.set_material(k, pass.materials(pass.types[pairs[k].i], pass.types[pairs[k].j]));
}

DiscPair coincident_pair(const ContactBatch& c, const DiscPair* pairs) {
  int lane = 0;
  while (c.is_defined(lane)) ++lane;
  return pairs[lane];
}

/// In the batch of pairs from `first` on, gives new contacts an unstretched spring and deletes the springs of
/// contacts that ended. In a pass that leaves displacements as they are, the batch works on a copy of them,
/// but contact onset is recorded in the lists all the same.
void change_contacts(ContactBatch& c, const PairPass& pass, int first, int count) {
  for (int k = 0; k < count; ++k) {
    if (c.touches(k) == (c.springs->touched[k] != 0)) continue;
    physics::begin_or_end_contact(c, k, {pass.dt, pass.predicted});
    pass.lists.change_contact(first + k, c.touches(k), c.springs->slip_rate[k]);
  }
}

template <Effects effects, bool observed>
std::optional<DiscPair> run_pass(ContactBatch& c, const PairPass& pass, const PairLoop::MoveDiscs& move_discs,
                                 const PairLoop::Observer& observer) {
  physics::InnerList& near = pass.lists.inner();
  const bool exceed_cache = pass.packed.exceed_cache();
  const bool may_move = move_discs && pass.lists.are_sorted();
  physics::SpringLanes unmoved;
  for (int k = 0; k < ContactBatch::lanes; ++k) c.set_material(k, pass.materials(1, 1));

  for (int first = 0; first < near.size(); first += ContactBatch::lanes) {
    const int count = std::min(ContactBatch::lanes, near.size() - first);
    const int ahead = exceed_cache ? std::min(count, near.size() - first - count) : 0;
    const BatchOfPairs batch{pass.packed.discs.data(),
                             pass.packed.loads.data(),
                             near.from(first),
                             count,
                             ahead,
                             pass.predicted,
                             pass.dt};
    if (!pass.one_material) set_materials(c, pass, batch.pairs, count);
    if (effects.spring()) {
      c.springs = &near.springs(first);
      if (!pass.advances_displacements) c.springs = &(unmoved = *c.springs);
      near.prefetch_springs(first + count, ahead);
    }
    const auto state = batch_geometry<effects>(c, batch);
    if (state.any_undefined) return coincident_pair(c, batch.pairs);
    if (state.any_changed) change_contacts(c, pass, first, count);
    batch_forces<effects>(c, batch);
    if constexpr (observed) observer(c, first, count);
    // The following pairs involve no disc before the first disc of the next pair.
    if (may_move && first + count < near.size()) move_discs(batch.pairs[count].i);
  }
  return {};
}

}  // namespace

void PairLoop::choose_instance(const Effects& effects) {
  const auto try_instance = [&]<Effects of_instance>() {
    if (effects != of_instance) return;
    plain_ = &run_pass<of_instance, false>;
    observed_ = &run_pass<of_instance, true>;
  };
  const auto try_all = [&]<int... numbers>(std::integer_sequence<int, numbers...> /*all*/) {
    (try_instance.template operator()<physics::effects_of_combination(numbers)>(), ...);
  };
  try_all(std::make_integer_sequence<int, physics::effect_combinations>{});
}

}  // namespace mikromakro::styles
