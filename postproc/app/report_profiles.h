// SPDX-License-Identifier: GPL-2.0-or-later
// Averages of a page: of all frames, and of windows of frames.
#pragma once

#include <cstdint>
#include <vector>

#include "averaging/block_errors.h"
#include "averaging/windows.h"
#include "io/tables/json.h"
#include "model/frame.h"
#include "options/average_options.h"

namespace mikromakro {

/// A number rounded to the six digits that pages show; nan remains.
double six_digits(double value);

/// Index, step and time (s) of a frame; `time_step` (s; 0: not given) for frames without a time.
Json place_json(const Frame& frame, double time_step);

/// The columns of an average, and for each its values and standard errors in all volumes.
Json columns_json(const Averager& averager);
Json averages_json(const Averager& averager, const TimeAverage& sums, const BlockErrors& errors);
BlockErrors errors_of(const Averager& averager, const TimeAverage& sums);

/// The windows of `average --every`, with the frames that they hold.
class PageWindows {
 public:
  PageWindows(const Averager& averager, const WindowRule& rule, std::size_t error_blocks);

  void add(const Frame& frame);
  /// The windows, and for each frame that was added its window (from 0) or null: it belongs to none.
  Json windows() const { return windows_; }
  Json windows_of_frames();

 private:
  void take(const Window& window);

  const Averager& averager_;
  WindowRule rule_;
  Windows open_;
  std::vector<Json> places_;  // of the frames that are in no window yet
  std::int64_t run_ = 0;
  Json windows_ = Json::array(), windows_of_frames_ = Json::array();
};

}  // namespace mikromakro
