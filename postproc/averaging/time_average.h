// SPDX-License-Identifier: GPL-2.0-or-later
// Mean of the sums over frames, and over blocks of frames.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Sums are averaged over the frames first, and quantities are computed once from the mean
/// (docs/conventions.md). Frames must be added in order, which is the order of summation. In addition to the
/// overall mean, means of successive blocks of frames are kept for error estimates: at most `most_blocks`
/// (even; 0 for none); blocks are merged in pairs when there would be more. Memory does not grow with the
/// number of frames.
///
/// A block holds frames of a single run: when blocks become longer, the remainder at the end of a run is in
/// no block, and runs shorter than a block have none. If that would leave less than a quarter of
/// `most_blocks`, as with many short runs, the block length stays the same and there may be more blocks.
class TimeAverage {
 public:
  explicit TimeAverage(std::size_t most_blocks = 64) : most_blocks_(most_blocks + most_blocks % 2) {}

  /// `run` identifies the run; the frames of a run must be contiguous.
  void add(const Rows& frame_sums, std::int64_t run = 0);

  std::int64_t frames() const { return frames_; }
  Rows mean() const { return total_ / static_cast<double>(frames_); }

  /// Means over the full blocks, in time order: for a single run between most_blocks/2 and most_blocks of
  /// them once there are most_blocks/2 frames, fewer before.
  const std::vector<Rows>& blocks() const { return blocks_; }
  /// The run of each block.
  const std::vector<std::int64_t>& runs() const { return runs_; }
  /// Frames per block, a power of two; a remainder shorter than a block is in none.
  std::int64_t block_length() const { return block_length_; }

 private:
  void add_to_total(const Rows& frame_sums);
  void close_block();
  std::size_t pairs() const;
  void merge_pairs();

  std::size_t most_blocks_;
  Rows total_, excess_;  // compensated sum over all frames: the total and its excess
  std::int64_t frames_ = 0;
  std::vector<Rows> blocks_;
  std::vector<std::int64_t> runs_;
  std::int64_t run_ = 0;  // of the open block
  Rows open_block_;
  std::int64_t open_frames_ = 0;
  std::int64_t block_length_ = 1;
};

/// Number of blocks for frames of this many numbers: up to 1024, because a single series needs many to
/// determine 2 tau, but fewer (at least 64) if they would take more than 4 MB.
std::size_t suitable_blocks(std::size_t numbers);

}  // namespace mikromakro
