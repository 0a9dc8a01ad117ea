// SPDX-License-Identifier: GPL-2.0-or-later
// Sums frames on several threads, in frame order.
#pragma once

#include <cstdint>
#include <functional>

#include "averaging/averager.h"
#include "io/frames/frame_stream.h"

namespace mikromakro {

/// The sums over one frame.
struct FrameSums {
  std::int64_t index = 0;  ///< see Frame::index
  std::int64_t step = 0;
  std::int64_t run = 0;       ///< see Frame::run
  double time = not_given;    ///< s
  double places = not_given;  ///< sum of the coordinates of some discs: the same bits for the same frame
  Eigen::ArrayXd walls = {};  ///< numbers of all Frame::walls, one after the other
  Rows sums;
};

/// Locates the next frame and returns the function that builds it; empty if there is none. Never called
/// concurrently. The returned function is called by the same thread, concurrently with those of other
/// threads.
using NextFrame = std::function<MakeFrame()>;
/// Computes the sums of one frame, from that frame alone; called concurrently.
using SumFrame = std::function<Rows(const Frame&)>;
/// Receives the sums of a frame.
using TakeSums = std::function<void(const FrameSums&)>;

/// Takes frames from `next`, sums each with `sum` and passes the sums to `take`, in frame order and from the
/// calling thread only: the result is bitwise independent of `threads` (>= 1, including the caller). One
/// thread at a time locates a frame while the others build and sum theirs. At most 2 threads + 2 frames are
/// in flight, so memory does not grow with the number of frames. Rethrows what `next` throws, after all
/// earlier frames have been taken, and what `take` throws.
void sum_in_order(const NextFrame& next, const SumFrame& sum, int threads, const TakeSums& take);

/// The same for the sums of one averager.
inline void sum_in_order(const NextFrame& next, const Averager& averager, int threads, const TakeSums& take) {
  sum_in_order(next, SumFrame([&](const Frame& frame) { return averager.frame_sums(frame); }), threads, take);
}

}  // namespace mikromakro
