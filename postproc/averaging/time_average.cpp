#include "averaging/time_average.h"

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

void TimeAverage::add(const Rows& frame_sums) {
  add_to(total_, frame_sums, frames_ == 0);
  ++frames_;
  if (most_blocks_ == 0) return;
  add_to(open_block_, frame_sums, open_frames_ == 0);
  if (++open_frames_ < block_length_) return;
  blocks_.push_back(open_block_ / static_cast<double>(block_length_));
  open_frames_ = 0;
  // Not before one more is there, so that `most_blocks` frames are as many blocks.
  if (blocks_.size() > most_blocks_) merge_pairs();
}

void TimeAverage::merge_pairs() {
  // The odd block at the end is the first half of a longer one.
  open_block_ = blocks_.back() * static_cast<double>(block_length_);
  open_frames_ = block_length_;
  blocks_ = merge_blocks(blocks_, 2);
  block_length_ *= 2;
}

std::vector<Rows> merge_blocks(const std::vector<Rows>& blocks, std::size_t group) {
  std::vector<Rows> merged;
  for (std::size_t first = 0; first + group <= blocks.size(); first += group) {
    Rows sum = blocks[first];
    for (std::size_t i = first + 1; i < first + group; ++i) sum += blocks[i];
    merged.push_back(sum / static_cast<double>(group));
  }
  return merged;
}

}  // namespace mikromakro
