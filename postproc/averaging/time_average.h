// Mean of the sums over frames.
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// Sums are averaged over frames first, quantities are solved from the mean once (docs/conventions.md).
/// Frames must be added in their order: it is the order of summation.
class TimeAverage {
 public:
  void add(const Rows& frame_sums) {
    if (frames_ == 0) {
      total_ = frame_sums;
    } else {
      total_ += frame_sums;
    }
    ++frames_;
  }

  std::int64_t frames() const { return frames_; }
  Rows mean() const { return total_ / static_cast<double>(frames_); }

 private:
  Rows total_;
  std::int64_t frames_ = 0;
};

}  // namespace mikromakro
