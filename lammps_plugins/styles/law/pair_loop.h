// SPDX-License-Identifier: GPL-2.0-or-later
// Pair loop: evaluates the contact law for the pairs of the inner list, in batches for SIMD, and adds the
// forces to the loads of the discs. One instance per combination of effects, each with and without
// observation of contacts, so that an effect that a scene does not use costs nothing.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "law/material_constants.h"
#include "law/packed_discs.h"
#include "law/pair_lists.h"
#include "physics/contact/contact_batch.h"
#include "physics/contact/contact_law.h"

namespace mikromakro::styles {

/// Input and output of one pass over the pairs.
struct PairPass {
  PackedDiscs& packed;
  PairLists& lists;
  const MaterialTable& materials;
  bool one_material;            // the same constants for all pairs of types
  const int* types;             // of discs, owned or ghost
  bool predicted;               // velocities are predicted for the time of the positions
  bool advances_displacements;  // false: the tangential displacements stay as they are
  double dt;                    // [s]; 0 if they stay
};

class PairLoop {
 public:
  /// Called with the index of a disc: no contact of a disc with a smaller index is still to come.
  using MoveDiscs = std::function<void(int before)>;
  /// Called for each batch, after its forces: pairs `first` to `first + count - 1` of the inner list are in
  /// lanes 0 to `count - 1`.
  using Observer = std::function<void(const physics::ContactBatch& batch, int first, int count)>;

  void choose_instance(const physics::Effects& effects);
  /// `move_discs` and `observer` may be empty. Returns nothing, or the pair that ended the pass early: two
  /// discs with the same centre, whose contact has no normal.
  std::optional<physics::DiscPair> run(const PairPass& pass, const MoveDiscs& move_discs,
                                       const Observer& observer) {
    return (observer ? observed_ : plain_)(*batch_, pass, move_discs, observer);
  }

 private:
  using Instance = std::optional<physics::DiscPair> (*)(physics::ContactBatch& batch, const PairPass& pass,
                                                        const MoveDiscs& move_discs,
                                                        const Observer& observer);

  std::unique_ptr<physics::ContactBatch> batch_ = std::make_unique<physics::ContactBatch>();
  Instance plain_ = nullptr, observed_ = nullptr;
};

}  // namespace mikromakro::styles
