// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/windows.h"

#include <cmath>
#include <utility>

namespace mikromakro {

Windows::Windows(const WindowRule& rule, std::size_t error_blocks, TakeWindow take)
    : rule_(rule), error_blocks_(error_blocks), take_(std::move(take)), open_(error_blocks) {}

void Windows::add(const FrameSums& frame) {
  if (frame.run != run_) end_run();
  run_ = frame.run;
  if (!rule_.moving) {
    add_to_open(frame);
    if (open_.sums.frames() == rule_.frames) close();
    return;
  }
  frames_.push_back(frame);
  if (std::ssize(frames_) < rule_.frames) return;
  for (const FrameSums& one : frames_) add_to_open(one);
  close();
  frames_.pop_front();
}

void Windows::add_to_open(const FrameSums& frame) {
  const double time = std::isnan(frame.time) && rule_.time_step > 0
                          ? rule_.time_step * static_cast<double>(frame.step)
                          : frame.time;
  if (open_.sums.frames() == 0) {
    open_.run = frame.run;
    open_.first_step = frame.step;
    open_.time = 0;
    open_.walls = Eigen::ArrayXd::Zero(frame.walls.size());
    step_sum_ = 0;
  }
  open_.sums.add(frame.sums, frame.run);
  open_.last_step = frame.step;
  // Relative to the first step, so that the sum of large steps fits.
  step_sum_ += frame.step - open_.first_step;
  open_.time += time;
  open_.walls += frame.walls;
}

void Windows::close() {
  const auto frames = static_cast<double>(open_.sums.frames());
  open_.step = static_cast<double>(open_.first_step) + static_cast<double>(step_sum_) / frames;
  open_.time /= frames;
  open_.walls /= frames;
  ++windows_;
  ++windows_of_run_;
  take_(open_);
  open_ = Window(error_blocks_);
}

void Windows::end_run() {
  if (open_.sums.frames() > 0)
    rests_.push_back({run_, open_.sums.frames(), open_.first_step, open_.last_step});
  // Overlapping windows leave frames out only if the run is shorter than one of them.
  if (!frames_.empty() && windows_of_run_ == 0)
    rests_.push_back({run_, std::ssize(frames_), frames_.front().step, frames_.back().step});
  open_ = Window(error_blocks_);
  frames_.clear();
  windows_of_run_ = 0;
}

}  // namespace mikromakro
