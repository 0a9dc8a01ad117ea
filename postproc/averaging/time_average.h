// Mean of the sums over frames, and over blocks of frames.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Sums are averaged over frames first, quantities are solved from the mean once (docs/conventions.md).
/// Frames must be added in their order: it is the order of summation. Beside the mean of all frames, means of
/// successive blocks of frames are kept, for errors: at most `most_blocks` of them (even; 0 for none), two
/// and two of which become one when there would be more. The memory does not grow with the number of frames.
class TimeAverage {
 public:
  explicit TimeAverage(std::size_t most_blocks = 64) : most_blocks_(most_blocks + most_blocks % 2) {}

  void add(const Rows& frame_sums);

  std::int64_t frames() const { return frames_; }
  Rows mean() const { return total_ / static_cast<double>(frames_); }

  /// Means over the full blocks, in time order: between most_blocks/2 and most_blocks of them after
  /// most_blocks/2 frames or more, fewer before.
  const std::vector<Rows>& blocks() const { return blocks_; }
  /// Frames in each block, a power of two; fewer than one block of frames at the end is in none.
  std::int64_t block_length() const { return block_length_; }

 private:
  void merge_pairs();

  std::size_t most_blocks_;
  Rows total_;
  std::int64_t frames_ = 0;
  std::vector<Rows> blocks_;
  Rows open_block_;
  std::int64_t open_frames_ = 0;
  std::int64_t block_length_ = 1;
};

/// Means of successive groups of `group` blocks; an incomplete group at the end is left out.
std::vector<Rows> merge_blocks(const std::vector<Rows>& blocks, std::size_t group);

}  // namespace mikromakro
