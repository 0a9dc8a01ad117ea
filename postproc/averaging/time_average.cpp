// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/time_average.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace mikromakro {
namespace {

void add_to(Rows& total, const Rows& sums, bool first) {
  if (first) {
    total = sums;
  } else {
    total += sums;
  }
}

}  // namespace

std::size_t suitable_blocks(std::size_t numbers) {
  constexpr std::size_t fewest = 64, most = 1024, bytes = std::size_t{1} << 22U;
  return std::clamp(std::bit_floor(bytes / sizeof(double) / std::max(numbers, std::size_t{1})), fewest, most);
}

/// Kahan summation: the rounding error of the total is corrected with the next frame.
void TimeAverage::add_to_total(const Rows& frame_sums) {
  if (frames_ == 0) {
    total_ = frame_sums;
    excess_ = Rows::Zero(frame_sums.rows(), frame_sums.cols());
    return;
  }
  const Rows rest = frame_sums - excess_, total = total_ + rest;
  excess_ = (total - total_) - rest;
  total_ = total;
}

void TimeAverage::add(const Rows& frame_sums, std::int64_t run) {
  add_to_total(frame_sums);
  ++frames_;
  if (most_blocks_ == 0) return;
  if (run != run_) open_frames_ = 0;
  run_ = run;
  add_to(open_block_, frame_sums, open_frames_ == 0);
  if (++open_frames_ == block_length_) close_block();
}

void TimeAverage::close_block() {
  blocks_.push_back(open_block_ / static_cast<double>(block_length_));
  runs_.push_back(run_);
  open_frames_ = 0;
  // Merge only when one block is in excess, so that `most_blocks` frames give that many blocks.
  if (blocks_.size() > most_blocks_ && 4 * pairs() >= most_blocks_) merge_pairs();
}

// Number of blocks that merge_pairs() would leave.
std::size_t TimeAverage::pairs() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < blocks_.size(); ++i) {
    if (runs_[i] != runs_[i + 1]) continue;
    ++count;
    ++i;
  }
  return count;
}

void TimeAverage::merge_pairs() {
  std::vector<Rows> merged;
  std::vector<std::int64_t> runs;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (i + 1 < blocks_.size() && runs_[i] == runs_[i + 1]) {
      merged.push_back((blocks_[i] + blocks_[i + 1]) / 2.0);
      runs.push_back(runs_[i]);
      ++i;
    } else if (i + 1 == blocks_.size()) {
      // An odd block at the end becomes the first half of a longer one.
      open_block_ = blocks_[i] * static_cast<double>(block_length_);
      open_frames_ = block_length_;
    }
  }
  blocks_ = std::move(merged);
  runs_ = std::move(runs);
  block_length_ *= 2;
}

}  // namespace mikromakro
