// SPDX-License-Identifier: GPL-2.0-or-later
// The ranks of an mpirun; the only interface to MPI.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "averaging/parallel/ordered_sums.h"
#include "io/frames/frame_selection.h"
#include "model/notes.h"

namespace mikromakro {

/// Whether Open MPI's mpirun started this process as one of several, and its rank (0 if not).
bool under_mpirun();
int launched_rank();

/// Initialises MPI if under_mpirun(), so that serial runs start quickly, and finalises it.
class Ranks {
 public:
  Ranks();
  struct Alone {};
  /// This process by itself, also under mpirun.
  explicit Ranks(Alone /*only*/) {}
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// Runs `action` on every rank; if it throws on any, all ranks throw the error of the lowest such rank.
  /// Collective. An exception other than Error becomes a failed run.
  void agree(const std::function<void()>& action) const;

  /// The number that rank 0 has. Collective.
  std::int64_t of_first(std::int64_t number) const;

  /// The frames of this rank: r, r + P, ... of the selected ones.
  FrameSelection own_part(FrameSelection selection) const;

  /// Collects the notes of all ranks on rank 0. Collective.
  void gather(Notes& notes) const;

  /// Passes the sums of all ranks' frames to `take` on rank 0, in frame order. `run` is called on every rank
  /// and passes the sums of the rank's own frames, in order, to its argument. Sums are exchanged in rounds of
  /// at most `most_bytes` per rank. If `run` throws on any rank, all ranks throw the error that a serial run
  /// would have met first. Collective.
  void gather_in_order(const std::function<void(const TakeSums&)>& run, const TakeSums& take,
                       std::int64_t most_bytes = 1 << 22) const;

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace mikromakro
