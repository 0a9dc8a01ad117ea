// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace mikromakro {

Progress::Progress(std::int64_t total_bytes, bool quiet)
    : total_(std::max<std::int64_t>(total_bytes, 1)),
      listener_(Listener::of_this_thread()),
      shown_(listener_ == nullptr && !quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r{:60}\r", "");
}

void Progress::update(std::int64_t bytes, std::int64_t frames) {
  const double part = std::clamp(static_cast<double>(bytes) / static_cast<double>(total_), 0.0, 1.0);
  if (listener_ != nullptr) return listener_->progress(part, frames);
  if (!shown_) return;
  const auto now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const double left = part > 0 ? seconds * (1 - part) / part : 0;
  const int filled = static_cast<int>(20 * part);
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} % {} frames, {:.1f} frames/s, {:.0f} s left ", "", filled,
             "", 20 - filled, 100 * part, frames, static_cast<double>(frames) / seconds, left);
  std::fflush(stderr);
}

}  // namespace mikromakro
