// SPDX-License-Identifier: GPL-2.0-or-later
// The ranks of a run under mpirun: the only place that knows MPI.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "averaging/parallel/ordered_sums.h"
#include "io/frames/frame_selection.h"
#include "model/notes.h"

namespace mikromakro {

/// Whether Open MPI's mpirun started this process beside others, and as which of them (0 if it did not).
bool under_mpirun();
int launched_rank();

/// Initialises MPI where under_mpirun(), so that a serial start stays quick, and ends it.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// Every rank does `action`; where it throws on any, all throw the error of the first of these. All ranks
  /// call it together. An exception that is no Error becomes a failed run.
  void agree(const std::function<void()>& action) const;

  /// The frames of this rank: r, r + P, ... of the selected ones.
  FrameSelection own_part(FrameSelection selection) const;

  /// Rank 0 gets the notes of all. All ranks call it together.
  void gather(Notes& notes) const;

  /// Gives the sums of all ranks' frames to `take` on rank 0, in the order of the frames. `run` is
  /// called on every rank; it gives the sums of the rank's own frames, in their order, to its argument. Sums
  /// wait for those of other ranks in rounds of at most `most_bytes` per rank. Where `run` throws on any
  /// rank, all throw the error that a single rank would have met first. All ranks call it together.
  void gather_in_order(const std::function<void(const TakeSums&)>& run, const TakeSums& take,
                       std::int64_t most_bytes = 1 << 22) const;

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace mikromakro
