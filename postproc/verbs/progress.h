// SPDX-License-Identifier: GPL-2.0-or-later
// Progress bar on a terminal.
#pragma once

#include <chrono>
#include <cstdint>

#include "verbs/listener.h"

namespace mikromakro {

/// Draws on stderr at most ten times per second; nothing if stderr is not a terminal or if `quiet`. A
/// Listener of this thread gets every update instead.
class Progress {
 public:
  Progress(std::int64_t total_bytes, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::int64_t bytes, std::int64_t frames);

 private:
  using Clock = std::chrono::steady_clock;
  std::int64_t total_;
  Listener* listener_;
  bool shown_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

}  // namespace mikromakro
