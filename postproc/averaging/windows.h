// SPDX-License-Identifier: GPL-2.0-or-later
// Averages as functions of time: windows of successive frames.
#pragma once

#include <cstdint>
#include <deque>
#include <Eigen/Core>
#include <functional>

#include "averaging/parallel/ordered_sums.h"
#include "averaging/time_average.h"

namespace mikromakro {

struct WindowRule {
  std::int64_t frames = 1;  ///< of each window
  bool moving = false;      ///< a window begins at every frame; otherwise where the one before it ended
  double time_step = 0;     ///< s per step, for frames without a time; 0: not known
};

/// Successive frames of one run. Step, time and numbers of walls are means over the frames, like the fields:
/// what changes in proportion to time has its mean at the mean time.
struct Window {
  explicit Window(std::size_t error_blocks) : sums(error_blocks) {}

  TimeAverage sums;
  std::int64_t run = 0;  ///< see Frame::run
  std::int64_t first_step = 0, last_step = 0;
  double step = 0;
  double time = 0;       ///< s; nan if not known
  Eigen::ArrayXd walls;  ///< see FrameSums::walls
};

using TakeWindow = std::function<void(const Window&)>;

/// Divides the frames into windows. A window holds frames of one run; frames at the end of a run that do not
/// fill a window are in none. Holds the sums of one window, or of its frames if windows overlap: these are
/// summed anew for each window, so that a window has the same bits by any rule.
class Windows {
 public:
  Windows(const WindowRule& rule, std::size_t error_blocks, TakeWindow take);

  /// Frames in order, the frames of a run contiguous; passes each window on as soon as it is full.
  void add(const FrameSums& frame);

  /// Call after the last frame.
  void finish() { end_run(); }

  std::int64_t windows() const { return windows_; }

  /// Frames at the end of a run that are in no window.
  struct Rest {
    std::int64_t run, frames, first_step, last_step;
  };
  const std::vector<Rest>& rests() const { return rests_; }

 private:
  void add_to_open(const FrameSums& frame);
  void close();
  void end_run();

  WindowRule rule_;
  std::size_t error_blocks_;
  TakeWindow take_;
  Window open_;
  std::int64_t step_sum_ = 0;     // of the open window
  std::deque<FrameSums> frames_;  // of the present window, if windows overlap
  std::int64_t run_ = -1;
  std::int64_t windows_ = 0, windows_of_run_ = 0;
  std::vector<Rest> rests_;
};

}  // namespace mikromakro
