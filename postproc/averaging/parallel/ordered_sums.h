// SPDX-License-Identifier: GPL-2.0-or-later
// Sums of frames on several threads, in the order of the frames.
#pragma once

#include <cstdint>
#include <functional>

#include "averaging/averager.h"
#include "io/frames/frame_stream.h"

namespace mikromakro {

/// What is summed over one frame.
struct FrameSums {
  std::int64_t index = 0;  ///< of the frame, see Frame
  std::int64_t step = 0;
  std::int64_t run = 0;  ///< of the frame, see Frame
  Rows sums;
};

/// Finds the next frame and gives the rest of the work to make it, nothing when there is none. Never called
/// by two threads at once; what it gives is called by the same thread, but beside others.
using NextFrame = std::function<MakeFrame()>;
/// Makes the sums of a frame, of this frame only; called by several threads at once.
using SumFrame = std::function<Rows(const Frame&)>;
/// Takes the sums of a frame.
using TakeSums = std::function<void(const FrameSums&)>;

/// Takes frame after frame from `next`, sums each by `sum` and gives the sums to `take`, in the order of
/// the frames and from the calling thread only: the result does not depend on `threads` (>= 1, the calling
/// one included), to the last bit. Frames are found by one thread at a time while the others make and sum
/// theirs; at most 2 threads + 2 frames are under way, so that memory does not grow with their number. Passes
/// on what `next` throws, after all earlier frames were taken, and what `take` throws.
void sum_in_order(const NextFrame& next, const SumFrame& sum, int threads, const TakeSums& take);

/// The same for the sums of one averager.
inline void sum_in_order(const NextFrame& next, const Averager& averager, int threads, const TakeSums& take) {
  sum_in_order(next, SumFrame([&](const Frame& frame) { return averager.frame_sums(frame); }), threads, take);
}

}  // namespace mikromakro
