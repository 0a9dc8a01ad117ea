// SPDX-License-Identifier: GPL-2.0-or-later
// Mean of the sums over frames, and over blocks of frames.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Sums are averaged over frames first, quantities are solved from the mean once (docs/conventions.md).
/// Frames must be added in their order: it is the order of summation. Beside the mean of all frames, means of
/// successive blocks of frames are kept, for errors: at most `most_blocks` of them (even; 0 for none), two
/// and two of which become one when there would be more. The memory does not grow with the number of frames.
///
/// A block holds frames of one run only: what is left at the end of a run when blocks become longer is in no
/// block, and runs that are shorter than a block have none. Where that would leave less than a quarter of
/// `most_blocks`, as with many short runs, blocks stay as they are, and there may be more of them.
class TimeAverage {
 public:
  explicit TimeAverage(std::size_t most_blocks = 64) : most_blocks_(most_blocks + most_blocks % 2) {}

  /// `run` is the same for the frames of one run, which come one after the other.
  void add(const Rows& frame_sums, std::int64_t run = 0);

  std::int64_t frames() const { return frames_; }
  Rows mean() const { return total_ / static_cast<double>(frames_); }

  /// Means over the full blocks, in time order: of one run between most_blocks/2 and most_blocks of them
  /// after most_blocks/2 frames or more, fewer before.
  const std::vector<Rows>& blocks() const { return blocks_; }
  /// The run of each block.
  const std::vector<std::int64_t>& runs() const { return runs_; }
  /// Frames in each block, a power of two; fewer than one block of frames at the end is in none.
  std::int64_t block_length() const { return block_length_; }

 private:
  void add_to_total(const Rows& frame_sums);
  void close_block();
  std::size_t pairs() const;
  void merge_pairs();

  std::size_t most_blocks_;
  Rows total_, excess_;  // the sum of all frames, and by how much it is too large
  std::int64_t frames_ = 0;
  std::vector<Rows> blocks_;
  std::vector<std::int64_t> runs_;
  std::int64_t run_ = 0;  // of the open block
  Rows open_block_;
  std::int64_t open_frames_ = 0;
  std::int64_t block_length_ = 1;
};

/// As many blocks as suit frames of so many numbers: up to 1024, since a single series tells 2 tau only from
/// many, fewer (64 at least) where they would take more than 4 MB.
std::size_t suitable_blocks(std::size_t numbers);

}  // namespace mikromakro
